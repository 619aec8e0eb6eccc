#pragma once

namespace flownav {

/// The version of this library, such as "0.1.0"; the project's CMakeLists.txt holds it.
const char* version();

}  // namespace flownav
