#include "rows.h"

namespace flownav::obstacles::rows::portable {
#include "rows.inl"
}  // namespace flownav::obstacles::rows::portable
