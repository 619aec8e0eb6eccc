#pragma once
#include <vector>

#include "flownav/core/ego_motion.h"
#include "flownav/motion/ray_flow.h"

namespace flownav {

/// One vector that passed sifting.
struct MotionSample {
    RayFlow ray;
    bool in_ground_window = false;
};

/// Working memory of estimate_motion(), kept between calls so that nothing is allocated.
struct MotionScratch {
    struct Row {
        double turn, pitch, value;  ///< pixels across e per radian of turn, of pitch; and measured
        double weight;
    };
    std::vector<Row> rows;
    std::vector<double> values;
    std::vector<double> sigmas;
};

/// Rotation and forward travel of the robot between the reference and the newer field, from vectors anywhere
/// in the image. Rotation: shorth (6) of omega_i (4), then biweight steps on the same equations, which are
/// free of the horizon's singularity when written across e. Travel: shorth (12) over the ground window, then
/// a biweight step. What cannot be measured is taken from the prediction and flagged. Throws nothing.
/// `noise_px`: deviation of the vectors across e that was found, pixels.
struct MotionEstimate {
    EgoMotion motion;
    double noise_px = 0.0;
};
MotionEstimate estimate_motion(const std::vector<MotionSample>& samples, const CameraModel& camera,
                               const MotionPrediction& prediction, const MotionParams& params,
                               MotionScratch& scratch);

/// Eq. (4), with e for a camera that travels along `travel`; meaningless where e and h are parallel.
double omega_of(const RayFlow& ray, const PlaneGeometry& plane, const Eigen::Vector2d& travel);

}  // namespace flownav
