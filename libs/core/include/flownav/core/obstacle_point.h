#pragma once
#include <Eigen/Core>

namespace flownav {

/// A point of an obstacle, in the ROBOT frame (x forward, y left, z up) at the end of its cycle.
struct ObstaclePoint {
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    double sigma_m = 0.0;                             ///< standard deviation of the range
    Eigen::Vector2d at_px = Eigen::Vector2d::Zero();  ///< position of its block in the cycle's LAST field
    bool moving = false;  ///< on a dynamic object; the range is that of its contact with the ground
};

/// A patch of confirmed floor: a short strip on the ground along the line of sight, in the ROBOT frame at the
/// end of its cycle.
struct GroundPatch {
    Eigen::Vector2d near_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d far_m = Eigen::Vector2d::Zero();
    double width_m = 0.0;  ///< width across the centre line, which runs from near_m to far_m
};

}  // namespace flownav
