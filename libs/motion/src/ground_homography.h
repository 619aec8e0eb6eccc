#pragma once
#include <Eigen/Core>

#include "flownav/core/camera_model.h"
#include "flownav/core/ego_motion.h"
#include "flownav/motion/pose_error.h"

namespace flownav::motion {

/// Motion between two fields as the flow determines it: turn, pitch and roll in rad, and travel in camera
/// heights.
struct PairMotion {
    static constexpr int turn = 0, pitch = 1, roll = 2, travel = 3, size = 4;
    Eigen::Vector4d values = Eigen::Vector4d::Zero();

    double chord_rad = 0.0;  ///< as in EgoMotion

    PairMotion() = default;
    PairMotion(const EgoMotion& motion, double height_m)
        : values(motion.omega_rad, motion.pitch_rad, 0.0, motion.forward_m / height_m),
          chord_rad(motion.chord_rad) {}

    double omega_rad() const { return values[turn]; }
    double pitch_rad() const { return values[pitch]; }
    double roll_rad() const { return values[roll]; }
    double heights() const { return values[travel]; }
};

/// H_newer_reference: maps rays of the ground from the reference to the newer field, both in the level
/// coordinates of `mount`, when the true angles of the camera are mount + error. Exact for finite motion.
Eigen::Matrix3d ground_homography(const CameraMount& mount, const MountAngles& error,
                                  const PairMotion& motion);

}  // namespace flownav::motion
