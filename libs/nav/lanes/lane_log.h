#pragma once

#include <mrpt/io/CFileGZOutputStream.h>

#include <filesystem>

#include "flownav/nav/lanes.h"
#include "flownav/nav/navigator.h"

namespace flownav::nav {

/// Writes decisions as MRPT's CLogFileRecord, which navlog-viewer shows.
class LaneLog {
  public:
    /// Makes the first file log_NNN.reactivenavlog that is not there yet. Throws std::runtime_error.
    explicit LaneLog(const std::filesystem::path& folder);

    void write(const LaneTables& tables, const Situation& situation, const Eigen::Vector2d& waypoint_robot_m,
               const CellLimits& limits, const LaneDecision& decision);

  private:
    mrpt::io::CFileGZOutputStream file_;
    bool first_ = true;  ///< record, which tells the viewer how the lanes run
};

}  // namespace flownav::nav
