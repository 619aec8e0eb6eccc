#pragma once
#include <opencv2/core/mat.hpp>

#include "frame.h"
#include "timeline.h"

namespace flownav::view {

struct MapPanelContent {
    const Frame& frame;
    const Timeline& timeline;
    double ahead_m = 8.0;    ///< reach of the map ahead of the robot
    double memory_s = 20.0;  ///< age up to which obstacle points are shown
    bool contacts = true;    ///< draws the contact scan
};

/// Converts a point of the robot frame (x forward, y left) to a pixel of a map panel of this size.
cv::Point map_px(const Eigen::Vector2d& robot_m, const cv::Size& size, double ahead_m);

/// Draws the surroundings in the robot frame (8-bit BGR, `size`), ahead is up: a grid in metres, the scan and
/// the obstacle points of the last finished cycle, the newest contacts with their intervals, points of
/// earlier cycles, and the paths by flow, odometry and ground truth from a common start.
cv::Mat map_panel(const MapPanelContent& content, const cv::Size& size);

}  // namespace flownav::view
