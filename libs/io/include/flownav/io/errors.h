#pragma once
#include <stdexcept>

namespace flownav::io {

/// An input cannot be opened or is not of the expected kind; what() names the file and the reason.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Something could not be written; what() names the file or folder and the reason.
struct OutputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace flownav::io
