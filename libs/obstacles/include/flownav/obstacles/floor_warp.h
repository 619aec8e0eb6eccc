#pragma once
#include <Eigen/Core>

#include "flownav/obstacles/level_image.h"

namespace flownav::obstacles {

/// Motion of the camera between two level images, and the floor, in level axes (x right, y down, z forward).
struct PairMotion {
    double forward_m = 0.0;    ///< displacement of the camera, in the frame half-way
    double right_m = 0.0;      ///< the same, to the right
    double omega_rad = 0.0;    ///< turn, > 0 to the left
    double pitch_rad = 0.0;    ///< > 0 raises the view
    double roll_rad = 0.0;     ///< > 0 turns the picture clockwise
    double slope = 0.0;        ///< tilt of the floor along the heading, > 0: it rises ahead
    double cross_slope = 0.0;  ///< tilt of the floor across the heading, > 0: it rises to the right
};

/// Where a pixel (u, v) of the newer image was in the reference, as a function of its inverse forward
/// distance. X = A (u, v, 1) + B w is the homogeneous pixel of the reference, w = forward part of the ray
/// over the forward distance for an upright surface, w = F (u, v, 1) for the floor.
struct PairWarp {
    Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
    Eigen::Vector3d B = Eigen::Vector3d::Zero();
    Eigen::RowVector3d floor = Eigen::RowVector3d::Zero();    ///< F
    Eigen::RowVector3d forward = Eigen::RowVector3d::Zero();  ///< forward part of the ray of (u, v, 1)
};

PairWarp pair_warp(const LevelCamera& reference, const LevelCamera& newer, const PairMotion& motion);

/// Homography of the floor from the newer image to the reference.
inline Eigen::Matrix3d floor_homography(const PairWarp& warp) {
    return warp.A + warp.B * warp.floor;
}

}  // namespace flownav::obstacles
