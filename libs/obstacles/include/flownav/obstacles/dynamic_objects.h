#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "flownav/core/obstacle_point.h"
#include "flownav/obstacles/classify.h"

namespace flownav::obstacles {

/// Result and working memory of mark_dynamic_objects(). `region_of`: index of each block's region, -1: none.
struct DynamicRegions {
    std::vector<int> region_of;
    std::vector<int> stack;
    int regions = 0;
};

/// True when two blocks may lie on the same dynamic object: their drifts agree within 20 % or 3 standard
/// deviations.
bool similar_drift(const Classification& p, const Classification& q);

/// True for vectors that no static object can cause: eliminated by (11), and pointing across e or backward
/// along it.
bool may_move(const Classification& classification);

/// Finds dynamic objects: connected regions of vectors that (11) eliminates and whose drifts agree with those
/// of their neighbours. Other measured blocks join a region when at least 3 of their neighbours with an
/// agreeing drift belong to it. Labels the blocks of a region BlockLabel::Moving and sets `regions`.
/// `neighbours`: indices of the nearest blocks of each block, then -1.
template <std::size_t N>
void mark_dynamic_objects(std::vector<Classification>& judgements,
                          const std::vector<std::array<int, N>>& neighbours, DynamicRegions& regions);

/// Contact of a dynamic object with the ground, from the lowest image row of its region by (8). The object's
/// flow does not determine its distance.
struct GroundContact {
    double forward_m = 0.0;  ///< x of the contact in the robot frame
    double sigma_m = 0.0;
};

/// Ground contact of a region. `lowest_px`: lower edge of the region's lowest block in the newest field.
/// Empty when the region reaches the lower border of the image (the object may extend below it), ends near or
/// above the horizon, or is so far away that sigma exceeds a third of the distance.
std::optional<GroundContact> ground_contact(const Eigen::Vector2d& lowest_px, const RayMapper& newest);

/// Point of an upright object that stands at `contact`, seen in pixel `at_px` of the newest field. Robot
/// frame, `moving` set. Empty outside the limits of `params`.
std::optional<ObstaclePoint> moving_point(const Eigen::Vector2d& at_px, const GroundContact& contact,
                                          const RayMapper& newest, const ObstacleParams& params);

constexpr int dynamic_neighbours_min = 3;   ///< neighbours of agreeing drift that a block needs
constexpr double dynamic_share_min = 0.05;  ///< of all blocks; crossing static edges cause smaller regions

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
