#pragma once
#include "flownav/motion/estimate_motion.h"
#include "rotation.h"

namespace flownav::motion {

/// Travel of the CAMERA along its direction; `support`: vectors that agree, 0 when it could not be measured.
struct Travel {
    double along_m = 0.0;
    double sigma_m = 0.0;
    int support = 0;
};

/// Eq. (12) over the ground window: shorth for a start, then biweight steps. Over all of the near floor when
/// the window shows too little, or when that says the same much more precisely.
Travel fit_travel(const std::vector<MotionSample>& samples, const CameraModel& camera,
                  const Eigen::Vector2d& direction, const Rotation& rotation, const MotionParams& params,
                  MotionScratch& scratch);

}  // namespace flownav::motion
