#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/math/footprint.h"

namespace flownav::report {

/// A drive to goals, in the frame of the map.
struct DriveScene {
    Polygon footprint_m;  ///< of the robot, in its own frame
    Pose2 start;
    std::optional<Pose2> end;         ///< empty when the robot never moved
    bool touched = false;             ///< the robot touched something at the end
    std::vector<Pose2> believed;      ///< the way by the robot's own localization
    std::vector<Pose2> true_way;      ///< empty when the truth is not known
    std::vector<Polygon> outlines_m;  ///< of all that can be hit; empty when it is not known
    std::vector<Eigen::Vector2d> goals_m;
    double goal_radius_m = 0.0;
};

/// A drive from above (8-bit BGR, 1000 px at the longest side; x to the right, y up): the map (white free,
/// black occupied, grey unknown), the believed way (orange), the true way (blue), outlines (purple), goals
/// (green), and the robot at both ends of the way, vermilion where it touched something.
cv::Mat drive_picture(const DriveScene& scene, const mrpt::maps::COccupancyGridMap2D& map);

}  // namespace flownav::report
