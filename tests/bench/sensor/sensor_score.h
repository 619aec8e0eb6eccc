#pragma once

#include <array>
#include <vector>

#include "flownav/config/config.h"
#include "post_drive.h"

namespace flownav::sensor_bench {

/// Ranges in which errors are counted apart: up to each limit.
constexpr std::array<double, 5> range_limits_m = {1.0, 1.5, 2.0, 3.0, 4.0};

struct Errors {
    std::vector<double> all;
    double mean() const;
    double deviation() const;  ///< about the mean
    double median() const;
};

/// What the sensor made of some drives.
struct Score {
    std::array<Errors, range_limits_m.size()> range;  ///< relative: measured over true range - 1
    Errors range_steady;  ///< the same, below 3 m, of cycles in which the turn rate did not change
    int passes = 0;       ///< a post stays in view at 1 to 3 m
    int missed = 0;       ///< and is never detected there
    int ahead = 0;        ///< of the passes: it begins within 10 degrees of straight ahead
    int ahead_missed = 0;
    Errors cycles_to_detect;
    int seen = 0;      ///< cycles times posts in view at 1 to 3 m
    int seen_hit = 0;  ///< of these: with a point on the post
    int cycles = 0;
    int points = 0;        ///< within the last of these ranges
    int false_points = 0;  ///< of these: farther than 0.2 m from any surface
    int gross_points = 0;  ///< of these: farther than 0.4 m
    int false_cycles = 0;
    int longest_burst = 0;  ///< cycles in a row with a false point
    int most_false = 0;     ///< in one cycle
    Errors turn_error_degps;
    Errors speed_error;  ///< relative, where it was measured
    int fields = 0;
    int fields_ok = 0;
    double seconds = 0.0;

    void add(const Score& other);
};

Score evaluate(const RecordedDrive& drive, const config::Config& config);

}  // namespace flownav::sensor_bench
