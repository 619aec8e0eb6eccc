#pragma once
#include "consensus.h"
#include "flownav/motion/estimate_motion.h"

namespace flownav::motion {

struct Rotation {
    RotationHypothesis turn;
    double sigma_omega_rad = 0.0;
    double noise_factor = 1.0;
    Support support;
};

/// The equations across e of all samples, in scratch.across. They are (4) before its division, each in units
/// of its deviation: the horizon is no special place for them. Linear in the rotation about `near`, which
/// makes them exact there. `direction`: unit vector of the camera's travel, (forward, left).
void set_up_rotation(const std::vector<MotionSample>& samples, const CameraModel& camera,
                     const Eigen::Vector2d& direction, const RotationHypothesis& near, Geometry geometry,
                     MotionScratch& scratch);

/// The rotation with the widest support among the samples.
Consensus start_rotation(const std::vector<MotionSample>& samples, const CameraModel& camera,
                         const Eigen::Vector2d& direction, const MotionPrediction& prediction,
                         const MotionParams& params, MotionScratch& scratch);

/// Biweight steps from a start on the equations in scratch.across.
Rotation fit_rotation(const RotationHypothesis& start, const MotionParams& params, MotionScratch& scratch);

/// Robust deviation of residuals that are in units of their expected deviation, kept within reason: outliers
/// must not make it look worse than it is. Reorders the residuals.
double noise_factor_of(std::vector<double>& residuals);

}  // namespace flownav::motion
