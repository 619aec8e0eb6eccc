#pragma once

namespace flownav::regress {

constexpr int exit_fine = 0;
constexpr int exit_failed = 1;       ///< a replay, or a comparison
constexpr int exit_usage = 2;        ///< arguments, configuration, manifest, expectation
constexpr int exit_incomplete = 3;   ///< merge: something is missing or failed
constexpr int exit_try_again = 75;   ///< results could not be written
constexpr int exit_by_signal = 128;  ///< plus the number of the signal, as shells have it

}  // namespace flownav::regress
