#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <vector>

#include "flownav/core/pose2.h"

namespace flownav::sim {

/// A path or a script that cannot be used; the message says where and why.
class PathError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct PathPoint {
    double time_s = 0.0;
    Pose2 T_world_robot;
};

/// Where a robot is at each time: on an arc between two points, at rest before the first and after the last.
class TimedPath {
  public:
    /// Throws PathError unless there is a point, times grow and all are numbers.
    explicit TimedPath(std::vector<PathPoint> points);

    Pose2 at(double time_s) const;
    double end_s() const { return points_.back().time_s; }

  private:
    std::vector<PathPoint> points_;
};

/// Speeds for a path without times.
struct PathSpeed {
    double v_mps = 0.4;
    double omega_radps = 0.5;  ///< the fastest it turns; narrow curves and turns on the spot take longer
};

/// Reads a CSV file whose first line names its columns: x_m, y_m and yaw_rad, and time_s, which begins
/// anywhere and counts from its first value. Without time_s the robot keeps `speed`, which must be given
/// then. Throws PathError with file and line.
TimedPath read_path(const std::filesystem::path& file, const std::optional<PathSpeed>& speed);

}  // namespace flownav::sim
