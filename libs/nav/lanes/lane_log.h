#pragma once

#include <mrpt/io/CFileGZOutputStream.h>

#include <filesystem>

#include "flownav/nav/lanes.h"
#include "flownav/nav/navigator.h"

namespace flownav::nav {

/// Writes decisions as MRPT's CLogFileRecord, which navlog-viewer shows.
class LaneLog {
  public:
    /// Creates the first unused file log_NNN.reactivenavlog. Throws std::runtime_error.
    explicit LaneLog(const std::filesystem::path& folder);

    void write(const LaneTables& tables, const Situation& situation, const Eigen::Vector2d& waypoint_robot_m,
               const mapping::OccupancyLimits& limits, const LaneDecision& decision);

  private:
    mrpt::io::CFileGZOutputStream file_;
    bool first_ = true;  ///< the next record describes the lanes to the viewer
};

}  // namespace flownav::nav
