#pragma once

namespace flownav::cli {

/// The exit statuses that all programs share.
enum class ExitStatus {
    Fine = 0,
    Usage = 1,   ///< bad usage or configuration; nothing was written
    Input = 2,   ///< the input is damaged or ended early; all that was readable was written
    Output = 3,  ///< output could not be written
};

/// The number that a program returns from main().
constexpr int exit_code(ExitStatus status) {
    return static_cast<int>(status);
}

}  // namespace flownav::cli
