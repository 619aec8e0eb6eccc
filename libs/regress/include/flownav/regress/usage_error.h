#pragma once

#include <stdexcept>

namespace flownav::regress {

/// A manifest, an expectation or arguments that cannot be used; what() names the file, the line, the value,
/// and what is allowed.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace flownav::regress
