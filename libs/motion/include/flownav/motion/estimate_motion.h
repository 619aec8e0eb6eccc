#pragma once
#include <vector>

#include "flownav/core/ego_motion.h"
#include "flownav/motion/ray_flow.h"

namespace flownav::motion {

/// One vector that passed sifting.
struct MotionSample {
    RayFlow ray;
    bool in_ground_window = false;
};

/// omega_i (4) of one vector, and where it was measured on the normalised plane.
struct OmegaSample {
    double omega_rad;
    Eigen::Vector2d at;
};

/// Working memory of estimate_motion(), kept between calls so that nothing is allocated.
struct MotionScratch {
    /// One equation across e: turn * omega + pitch * pitch rate = measured, in units of the vector's
    /// deviation.
    struct RotationEquation {
        double turn, pitch, measured, weight;
        double deviation_px;
        Eigen::Vector2d at;
    };
    /// The travel that one vector of the floor stands for, with its deviation.
    struct TravelEquation {
        double travel_m, sigma_m;
    };
    /// The same equations side by side, for those who ask all of them the same again and again.
    struct InlierCounts {
        std::vector<double> turn, pitch, measured, deviation_px;
        std::vector<int> cell, agrees;
        std::vector<int> of_cell;  ///< votes of every cell
    };
    std::vector<OmegaSample> omegas;
    std::vector<RotationEquation> rotation_equations;
    InlierCounts inlier_counts;
    std::vector<TravelEquation> floor, window;
    std::vector<double> values;
};

struct MotionEstimate {
    EgoMotion motion;
    bool as_predicted = false;   ///< the turn lies within the prediction's tolerance
    double support_share = 0.0;  ///< of the image's cells, those that agree with the rotation
    double noise_factor = 1.0;   ///< how much larger the errors are than the vectors' own deviations say
};

/// Rotation and forward travel of the robot between the reference and the newer field, from vectors anywhere
/// in the image. What cannot be measured is taken from the prediction and flagged. Throws nothing, and
/// allocates only when the scratch has to grow.
MotionEstimate estimate_motion(const std::vector<MotionSample>& samples, const CameraModel& camera,
                               const MotionPrediction& prediction, const MotionParams& params,
                               MotionScratch& scratch);

/// The predicted motion, with nothing in it measured.
EgoMotion unmeasured_motion(const MotionPrediction& prediction);

/// Eq. (4), with e for a camera that travels along `travel`; meaningless where e and h are parallel.
double omega_of(const RayFlow& ray, const PlaneGeometry& plane, const Eigen::Vector2d& travel);

}  // namespace flownav::motion
