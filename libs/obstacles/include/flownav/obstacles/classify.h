#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "flownav/core/ego_motion.h"
#include "flownav/core/flow_vector.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/obstacles/params.h"

namespace flownav::obstacles {

/// What one vector says about the place it looks at.
struct Classification {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();     ///< where, on the normalised plane half-way
    Eigen::Vector2d drift = Eigen::Vector2d::Zero();  ///< d of Eq. (9), an image, on the normalised plane
    double drift_sigma = 0.0;                         ///< standard deviation of drift in its worse direction
    double inverse_depth = 0.0;                       ///< 1/Z at `at`, 1/m
    double sigma = 0.0;                               ///< standard deviation of inverse_depth, 1/m
    double excess_px = 0.0;  ///< Eq. (13): longer than on the ground by so many pixels
    double across_px = 0.0;  ///< Eq. (11): distance from the line through the FOE
    BlockLabel label = BlockLabel::Unplaced;
    bool measured = false;  ///< false: there is no vector
};

/// What the vectors of one image have in common.
struct ClassifierInput {
    ClassifierInput() = default;
    /// `noise_factor`: errors of this image over what the deviations of its vectors say.
    ClassifierInput(const CameraModel& camera, const EgoMotion& motion, double noise_factor_of_image);

    PlaneGeometry plane;
    Eigen::Vector2d displacement_m = Eigen::Vector2d::Zero();  ///< of the camera on the ground
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();           ///< one, on the normalised plane
    double noise_factor = 1.0;
    double travel_error = 0.0;  ///< relative deviation of the travel
};

/// Eliminates by (11) and decides by (13). `travel`: a vector without its rotation, see Derotation.
/// A candidate obstacle comes back as BlockLabel::Unsupported until its neighbours have been asked.
Classification classify(const RayFlow& travel, const ClassifierInput& motion, const ObstacleParams& params);

/// The neighbourhood filter: candidates with at least params.neighbours neighbours of about the same depth
/// become obstacles. `neighbours`: indices of the nearest blocks of each, -1 behind the last.
template <std::size_t N>
void confirm_by_neighbours(std::vector<Classification>& judgements,
                           const std::vector<std::array<int, N>>& neighbours, const ObstacleParams& params);

/// True when two depths are the same within 15 %.
bool similar_depth(const Classification& p, const Classification& q);

template <std::size_t N>
void confirm_by_neighbours(std::vector<Classification>& judgements,
                           const std::vector<std::array<int, N>>& neighbours, const ObstacleParams& params) {
    const auto candidate = [](const Classification& j) {
        return j.label == BlockLabel::Unsupported || j.label == BlockLabel::Obstacle;
    };
    for (std::size_t i = 0; i < judgements.size(); ++i) {
        Classification& own = judgements[i];
        if (!candidate(own)) continue;
        int agreeing = 0;
        for (const int k : neighbours[i]) {
            agreeing += k >= 0 && candidate(judgements[k]) && similar_depth(own, judgements[k]);
        }
        if (agreeing >= params.neighbours) own.label = BlockLabel::Obstacle;
    }
}

}  // namespace flownav::obstacles
