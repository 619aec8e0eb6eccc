#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "flownav/core/ego_motion.h"
#include "flownav/core/flow_vector.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/obstacles/params.h"

namespace flownav::obstacles {

/// Classification of one vector.
struct Classification {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();     ///< normalised point half-way along the vector
    Eigen::Vector2d drift = Eigen::Vector2d::Zero();  ///< d of Eq. (9) per image, on the normalised plane
    double drift_sigma = 0.0;    ///< larger of the standard deviations of drift in x and y
    double inverse_depth = 0.0;  ///< 1/Z at `at`, 1/m
    double sigma = 0.0;          ///< standard deviation of inverse_depth, 1/m
    double excess_px = 0.0;      ///< Eq. (13): pixels along e by which the vector exceeds that of the ground
    double across_px = 0.0;      ///< Eq. (11): distance from the line through the FOE, in pixels
    BlockLabel label = BlockLabel::Unplaced;
    bool measured = false;  ///< false: there is no vector, or e is 0
};

/// Values common to the vectors of one image.
struct ClassifierInput {
    ClassifierInput() = default;
    /// `noise_factor_of_image`: ratio of the image's residuals to the standard deviations of its vectors.
    ClassifierInput(const CameraModel& camera, const EgoMotion& motion, double noise_factor_of_image);

    PlaneGeometry plane;
    Eigen::Vector2d displacement_m = Eigen::Vector2d::Zero();  ///< of the camera, (forward, left)
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();           ///< size of one pixel on the normalised plane
    double noise_factor = 1.0;
    double travel_error = 0.0;  ///< relative standard deviation of the travel
};

/// Classifies one vector: eliminates by (11), decides by (13). `travel`: a vector without its rotation, see
/// Derotation. An obstacle candidate is labelled BlockLabel::Unsupported until confirm_by_neighbours().
Classification classify(const RayFlow& travel, const ClassifierInput& motion, const ObstacleParams& params);

/// Neighbourhood filter: labels candidates as obstacles when at least params.neighbours of their neighbours
/// are candidates of similar depth. `neighbours`: indices of the nearest blocks of each block, then -1.
template <std::size_t N>
void confirm_by_neighbours(std::vector<Classification>& judgements,
                           const std::vector<std::array<int, N>>& neighbours, const ObstacleParams& params);

/// True when two inverse depths differ by less than 15 % of the larger one.
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
