#pragma once

#include <array>
#include <vector>

#include "flownav/config/config.h"
#include "post_drive.h"

namespace flownav::sensor_bench {

/// Upper limits of the ranges with separate errors.
constexpr std::array<double, 5> range_limits_m = {1.0, 1.5, 2.0, 3.0, 4.0};

struct Errors {
    std::vector<double> all;
    double mean() const;
    double deviation() const;  ///< standard deviation
    double median() const;
};

/// Results of the sensor over several drives.
struct Score {
    std::array<Errors, range_limits_m.size()> range;  ///< relative error: measured over true range - 1
    Errors range_steady;  ///< relative error below 3 m, in cycles with a constant turn rate
    int passes = 0;       ///< number of times that a post stays in view at 1 to 3 m
    int missed = 0;       ///< passes without a detection
    int ahead = 0;        ///< passes that begin within 10 degrees of straight ahead
    int ahead_missed = 0;
    Errors cycles_to_detect;
    int seen = 0;      ///< posts in view at 1 to 3 m, summed over the cycles
    int seen_hit = 0;  ///< the part of `seen` with a point on the post
    int cycles = 0;
    int points = 0;        ///< points within the last range limit
    int false_points = 0;  ///< points farther than 0.2 m from all surfaces
    int gross_points = 0;  ///< points farther than 0.4 m from all surfaces
    int false_cycles = 0;
    int longest_burst = 0;  ///< maximum number of consecutive cycles with a false point
    int most_false = 0;     ///< maximum number of false points in one cycle
    Errors turn_error_degps;
    Errors speed_error;  ///< relative error of measured speeds
    int fields = 0;
    int fields_ok = 0;
    double seconds = 0.0;

    void add(const Score& other);
};

Score evaluate(const RecordedDrive& drive, const config::Config& config);

}  // namespace flownav::sensor_bench
