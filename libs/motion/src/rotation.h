#pragma once
#include "flownav/motion/estimate_motion.h"

namespace flownav {

struct Rotation {
    double omega_rad = 0.0;
    double pitch_rad = 0.0;
    double sigma_omega_rad = 0.0;
    double noise_factor = 1.0;
    int inliers = 0;  ///< vectors within lambda across e
};

/// Shorth (6) of omega_i (4) for a start, then biweight steps on the equations across e. Those are (4) before
/// its division, each in units of its deviation: the horizon is no special place for them. `direction`: unit
/// vector of the camera's travel, (forward, left).
Rotation fit_rotation(const std::vector<MotionSample>& samples, const CameraModel& camera,
                      const Eigen::Vector2d& direction, const MotionParams& params, MotionScratch& scratch);

/// Robust deviation of residuals that are in units of their expected deviation, kept within reason: outliers
/// must not make it look worse than it is. Reorders the residuals.
double noise_factor_of(std::vector<double>& residuals);

}  // namespace flownav
