#pragma once

namespace flownav {

/// Version of this library, such as "0.1.0", as set in the project's CMakeLists.txt.
const char* version();

}  // namespace flownav
