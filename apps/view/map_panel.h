#pragma once
#include <opencv2/core/mat.hpp>

#include "frame.h"
#include "timeline.h"

namespace flownav::view {

struct MapPanelContent {
    const Frame& frame;
    const Timeline& timeline;
    double ahead_m = 8.0;    ///< so far the map reaches ahead of the robot
    double memory_s = 20.0;  ///< obstacle points of so long ago are shown
};

/// Where a point of the robot frame (x forward, y left) lies in a map panel of this size.
cv::Point map_px(const Eigen::Vector2d& robot_m, const cv::Size& size, double ahead_m);

/// The surroundings in the robot frame (8-bit BGR, `size`), ahead is up: a grid in metres, the scan and the
/// obstacle points of the last finished cycle, points of the cycles before, and the ways driven by flow,
/// odometry and ground truth, all of which start in the same place.
cv::Mat map_panel(const MapPanelContent& content, const cv::Size& size);

}  // namespace flownav::view
