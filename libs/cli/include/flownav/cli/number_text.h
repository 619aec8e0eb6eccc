#pragma once
#include <string>

namespace flownav::cli {

/// `value` with a fixed number of decimals, the same in every locale; empty when it is not finite, and never
/// "-0".
std::string fixed_text(double value, int decimals);

/// A time in seconds since the epoch, with microseconds.
std::string time_text(double timestamp_s);

}  // namespace flownav::cli
