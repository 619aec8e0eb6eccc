#include "flownav/core/version.h"

namespace flownav {

const char* version() {
    return FLOWNAV_VERSION;
}

}  // namespace flownav
