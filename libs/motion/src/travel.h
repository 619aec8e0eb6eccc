#pragma once
#include "flownav/motion/estimate_motion.h"
#include "rotation.h"

namespace flownav::motion {

/// Travel of the CAMERA along its direction. `support`: number of agreeing vectors, 0 when it could not be
/// measured.
struct Travel {
    double along_m = 0.0;
    double sigma_m = 0.0;
    int support = 0;
};

/// Eq. (12) over the ground window: shorth as the start, then biweight steps. Uses the whole near floor when
/// the window has too few vectors, or when the floor agrees with it and is much more precise.
Travel fit_travel(const std::vector<MotionSample>& samples, const CameraModel& camera,
                  const Eigen::Vector2d& direction, const Rotation& rotation, const MotionParams& params,
                  MotionScratch& scratch);

}  // namespace flownav::motion
