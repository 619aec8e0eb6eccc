#pragma once

namespace flownav::regress {

constexpr int exit_fine = 0;
constexpr int exit_failed = 1;       ///< a replay or a comparison failed
constexpr int exit_usage = 2;        ///< invalid arguments, configuration, manifest or expectation
constexpr int exit_incomplete = 3;   ///< merge: results are missing or failed
constexpr int exit_try_again = 75;   ///< results could not be written
constexpr int exit_by_signal = 128;  ///< plus the number of the signal, as in shells

}  // namespace flownav::regress
