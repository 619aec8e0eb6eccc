#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "flownav/core/obstacle_point.h"
#include "flownav/obstacles/classify.h"

namespace flownav::obstacles {

/// Working memory of mark_dynamic_objects(), and its result: the region each block belongs to, -1: none.
struct DynamicRegions {
    std::vector<int> region_of;
    std::vector<int> stack;
    int regions = 0;
};

/// True when two blocks may lie on the same mover: their drifts (flow less rotation, an image) agree.
bool similar_drift(const Classification& p, const Classification& q);

/// True for vectors that no thing at rest can have: across e, or backward along it.
bool may_move(const Classification& classification);

/// Finds what moves by itself: vectors that (11) eliminates, that agree with their neighbours about how they
/// drift, and that hang together. Blocks among them that happened to pass (11) belong to them as well, be
/// they candidates of (13) or not. All get BlockLabel::Moving and the number of their region. `neighbours`:
/// indices of the nearest blocks of each, -1 behind the last.
template <std::size_t N>
void mark_dynamic_objects(std::vector<Classification>& judgements,
                          const std::vector<std::array<int, N>>& neighbours, DynamicRegions& regions);

/// Where something that moves touches the ground, from the lowest image row of its region by (8). Its
/// distance does not follow from its flow.
struct GroundContact {
    double forward_m = 0.0;  ///< of the contact, in the robot frame
    double sigma_m = 0.0;
};

/// `lowest_px`: the lower edge of the region's lowest block, in the newest field. Nothing when the region
/// reaches to the border of the image (it may go on below), over the horizon, or too far to tell.
std::optional<GroundContact> ground_contact(const Eigen::Vector2d& lowest_px, const RayMapper& newest);

/// A point of an upright thing that stands at `contact`, seen in pixel `at_px` of the newest field; robot
/// frame, marked as moving. Nothing out of the limits of `params`.
std::optional<ObstaclePoint> moving_point(const Eigen::Vector2d& at_px, const GroundContact& contact,
                                          const RayMapper& newest, const ObstacleParams& params);

constexpr int dynamic_neighbours_min = 3;  ///< that drift alike
constexpr double dynamic_share_min =
    0.05;  ///< of all blocks; crossings of edges at rest look like small movers

template <std::size_t N>
void mark_dynamic_objects(std::vector<Classification>& judgements,
                          const std::vector<std::array<int, N>>& neighbours, DynamicRegions& regions) {
    const std::size_t n = judgements.size();
    regions.region_of.assign(n, -1);
    regions.regions = 0;
    const auto agreeing = [&](std::size_t i, auto&& counts) {
        int count = 0;
        for (const int k : neighbours[i])
            count += k >= 0 && counts(k) && similar_drift(judgements[i], judgements[k]);
        return count;
    };
    const auto is_core = [&](std::size_t i) {
        return may_move(judgements[i]) &&
               agreeing(i, [&](int k) { return may_move(judgements[k]); }) >= dynamic_neighbours_min;
    };
    for (std::size_t seed = 0; seed < n; ++seed) {
        if (regions.region_of[seed] >= 0 || !is_core(seed)) continue;
        const int region = regions.regions;
        int size = 0;
        regions.stack.assign(1, static_cast<int>(seed));
        regions.region_of[seed] = region;
        while (!regions.stack.empty()) {
            const int i = regions.stack.back();
            regions.stack.pop_back();
            ++size;
            for (const int k : neighbours[i]) {
                if (k < 0 || regions.region_of[k] >= 0 || !judgements[k].measured) continue;
                if (!similar_drift(judgements[i], judgements[k])) continue;
                const bool joins = may_move(judgements[k]) || agreeing(k, [&](int m) {
                                                                  return regions.region_of[m] == region;
                                                              }) >= dynamic_neighbours_min;
                if (!joins) continue;
                regions.region_of[k] = region;
                regions.stack.push_back(k);
            }
        }
        if (size < dynamic_share_min * static_cast<double>(n)) {
            std::replace(regions.region_of.begin(), regions.region_of.end(), region, -1);
        } else {
            ++regions.regions;
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        if (regions.region_of[i] >= 0) judgements[i].label = BlockLabel::Moving;
}

}  // namespace flownav::obstacles
