#pragma once
#include <stdexcept>

namespace flownav::cli {

/// Arguments, or a file that they name, cannot be used; what() names the value and says what is allowed.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace flownav::cli
