#pragma once
#include "flownav/core/pose2.h"

namespace flownav {

/// The sensor that a part of a motion comes from.
enum class MotionSource {
    Prediction,  ///< none: the rates of earlier fields go on
    Flow,
    Wheels,
    Gyro,
};

/// Name of a source, as written to files.
const char* to_string(MotionSource source);

/// Motion of the robot from the reference field to a newer one.
struct EgoMotion {
    double omega_rad = 0.0;         ///< turn about the robot's axis, > 0 to the LEFT
    double pitch_rad = 0.0;         ///< turn about the camera's x axis, > 0 raises the camera's view
    double forward_m = 0.0;         ///< T, chord of the robot's axis, > 0 forward
    double chord_rad = 0.0;         ///< direction of the chord from half the turn; 0 when the turn was steady
    double sigma_omega_rad = 0.0;   ///< standard error of omega
    double sigma_forward_m = 0.0;   ///< standard error of T
    bool omega_measured = false;    ///< by flow, wheels or gyro; false: omega is the prediction
    bool forward_measured = false;  ///< by flow or wheels; false: T was carried over
    int inliers = 0;                ///< vectors that support omega
    int ground_window = 0;          ///< vectors that support T
    MotionSource omega_source = MotionSource::Prediction;
    MotionSource forward_source = MotionSource::Prediction;
};

/// T_reference_robot: the robot's pose at the newer field, in its frame at the reference field.
inline Pose2 pose_after(const EgoMotion& motion) {
    return along_arc(motion.omega_rad, motion.forward_m, motion.chord_rad);
}

/// T_reference_mid: the robot's pose half-way through the motion, where vectors are evaluated.
inline Pose2 pose_half_way(const EgoMotion& motion) {
    return along_arc(0.5 * motion.omega_rad, 0.5 * motion.forward_m, motion.chord_rad);
}

}  // namespace flownav
