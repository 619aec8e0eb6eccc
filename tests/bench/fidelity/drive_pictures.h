#pragma once
#include <string>
#include <vector>

#include "chain_run.h"

namespace flownav::fidelity {

/// An obstacle point of a drive and its distance to the nearest surface.
struct JudgedPoint {
    Eigen::Vector2d in_robot_m;  ///< forward, left
    Eigen::Vector2d in_world_m;  ///< by the true pose
    double off_m = 0.0;
};

/// Data for the pictures of a drive.
struct DriveRecord {
    sim::World world;
    std::vector<Eigen::Vector2d> truth_m, flow_m, odometry_m;  ///< paths
    std::vector<JudgedPoint> points;
};

// Each returns a complete SVG file.

std::string paths_picture(const DriveRecord& drive);
std::string points_picture(const DriveRecord& drive);

}  // namespace flownav::fidelity
