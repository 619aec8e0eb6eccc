#include "rows.h"

namespace flownav::obstacles::rows::avx2 {
#include "rows.inl"
}  // namespace flownav::obstacles::rows::avx2
