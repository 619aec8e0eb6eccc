#pragma once
#include <Eigen/Core>

namespace flownav {

/// A point of an obstacle, in the ROBOT frame (x forward, y left, z up) at the end of its cycle.
struct ObstaclePoint {
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    double sigma_m = 0.0;                             ///< standard deviation of the range
    Eigen::Vector2d at_px = Eigen::Vector2d::Zero();  ///< its block's place in the cycle's LAST field
    bool moving = false;  ///< it moves by itself: the range is that of its contact with the ground
};

/// A patch of floor that was seen to be floor: a short strip on the ground along the line of sight, in the
/// ROBOT frame at the end of its cycle.
struct GroundPatch {
    Eigen::Vector2d near_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d far_m = Eigen::Vector2d::Zero();
    double width_m = 0.0;  ///< across the line from near to far, which is its middle
};

}  // namespace flownav
