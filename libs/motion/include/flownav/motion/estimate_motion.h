#pragma once
#include <vector>

#include "flownav/core/ego_motion.h"
#include "flownav/motion/ray_flow.h"

namespace flownav::motion {

/// A vector that passed sifting.
struct MotionSample {
    RayFlow ray;
    bool in_ground_window = false;
};

/// omega_i of Eq. (4) of one vector, in rad, and the vector's point on the normalised plane.
struct OmegaSample {
    double omega_rad;
    Eigen::Vector2d at;
};

/// Working memory of estimate_motion(), kept between calls to avoid allocations.
struct MotionScratch {
    /// Equation of one vector across e: turn * omega + pitch * pitch angle = measured, in units of the
    /// vector's standard deviation.
    struct RotationEquation {
        double turn, pitch, measured, weight;
        double deviation_px;
        Eigen::Vector2d at;
    };
    /// Travel measured by one vector of the floor, with its standard deviation.
    struct TravelEquation {
        double travel_m, sigma_m;
    };
    /// The rotation equations as one array per coefficient, for fast counting of inliers.
    struct InlierCounts {
        std::vector<double> turn, pitch, measured, deviation_px;
        std::vector<int> cell, agrees;
        std::vector<int> of_cell;  ///< number of vectors of each cell
    };
    std::vector<OmegaSample> omegas;
    std::vector<RotationEquation> rotation_equations;
    InlierCounts inlier_counts;
    std::vector<TravelEquation> floor, window;
    std::vector<double> values;
};

struct MotionEstimate {
    EgoMotion motion;
    bool as_predicted = false;   ///< the start of the fit lies within the prediction's tolerance
    double support_share = 0.0;  ///< share of the image's cells that agree with the rotation
    double noise_factor = 1.0;   ///< ratio of the residuals to the vectors' own standard deviations
};

/// Estimates rotation and forward travel of the robot between the reference and the newer field, from vectors
/// anywhere in the image. Values that cannot be measured are taken from the prediction and flagged. Does not
/// throw; allocates only when the scratch has to grow.
MotionEstimate estimate_motion(const std::vector<MotionSample>& samples, const CameraModel& camera,
                               const MotionPrediction& prediction, const MotionParams& params,
                               MotionScratch& scratch);

/// Returns the predicted motion with all values flagged as not measured.
EgoMotion unmeasured_motion(const MotionPrediction& prediction);

/// Eq. (4) with e for a camera that travels along `travel`, in rad. Not finite where e and h are parallel.
double omega_of(const RayFlow& ray, const PlaneGeometry& plane, const Eigen::Vector2d& travel);

}  // namespace flownav::motion
