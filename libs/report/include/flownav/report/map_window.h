#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/report/contact_segments.h"

namespace flownav::report {

/// What is drawn on the map, all of it in the map's frame.
struct MapWindowScene {
    std::vector<Pose2> path;                ///< of the robot; it stands at the last pose
    std::vector<Eigen::Vector2d> points_m;  ///< obstacle points of the newest cycle
    std::vector<ContactSegment> contacts;   ///< of the newest contact scan
};

/// A square picture for people (8-bit BGR, size_px wide) of the size_m metres of the map around the robot, x
/// to the right and y up: white is free, black is occupied, grey unknown; the path, the robot as an arrow
/// head in the direction it looks, the newest obstacle points and contacts, and a scale bar.
cv::Mat map_window(const mrpt::maps::COccupancyGridMap2D& grid, const MapWindowScene& scene, double size_m,
                   int size_px);

}  // namespace flownav::report
