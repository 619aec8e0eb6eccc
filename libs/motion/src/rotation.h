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

/// Fills scratch.rotation_equations with the equations across e of all samples. They are Eq. (4) before its
/// division, each in units of its standard deviation, and have no singularity on the horizon. They are
/// linearised at the rotation `near`. `direction`: unit vector of the camera's travel, (forward, left).
void set_up_rotation(const std::vector<MotionSample>& samples, const CameraModel& camera,
                     const Eigen::Vector2d& direction, const RotationHypothesis& near, Geometry geometry,
                     MotionScratch& scratch);

/// Returns the predicted rotation when its support suffices, else the result of find_consensus().
Consensus start_rotation(const std::vector<MotionSample>& samples, const CameraModel& camera,
                         const Eigen::Vector2d& direction, const MotionPrediction& prediction,
                         const MotionParams& params, MotionScratch& scratch);

/// Refines a rotation by biweight steps on scratch.rotation_equations.
Rotation fit_rotation(const RotationHypothesis& start, const MotionParams& params, MotionScratch& scratch);

/// Robust deviation of residuals in units of their expected deviation, limited to 0.5..3 so that outliers do
/// not inflate it. Reorders the residuals.
double noise_factor_of(std::vector<double>& residuals);

}  // namespace flownav::motion
