#pragma once
#include "integrate.h"
#include "rate_control.h"

namespace flownav::pipeline {

/// Comparisons with one reference.
struct CycleQuality {
    int first_inliers = 0;  ///< of the cycle's first image
    int failures = 0;       ///< images in a row that could not be compared
};

/// The length of the running cycle, as planned after its newest image.
struct CyclePlan {
    int images = 0;  ///< r
    bool ends = false;
    CycleQuality quality;
};

/// Plans the cycle after its image `image_of_cycle` (1..). A cycle ends before its time when the view has
/// changed so much that fewer than half of its first inliers are left, or when two images in a row could not
/// be compared with the reference; an image that could not be compared ends no cycle otherwise. An image
/// whose whole motion was told by other sensors counts as compared.
inline CyclePlan plan_after(const AcceptedMotion& accepted, const Rates& rates, int image_of_cycle,
                            const CycleQuality& before, double since_last_s, const RateParams& params) {
    constexpr int failures_max = 2;
    constexpr int blind_cycle_images = 3;  // while the speed, and with it the flow to come, is unknown
    const bool ok = accepted.status == FieldStatus::Ok;
    const bool compared = ok || accepted.is_told();
    CyclePlan plan;
    plan.images =
        rates.v_known ? plan_cycle(params, rates.v_mps * since_last_s, since_last_s) : blind_cycle_images;
    plan.quality = before;
    plan.quality.failures = compared ? 0 : before.failures + 1;
    if (ok && image_of_cycle == 1) plan.quality.first_inliers = accepted.motion.inliers;
    const bool degraded = plan.quality.failures >= failures_max ||
                          (ok && 2 * accepted.motion.inliers < plan.quality.first_inliers);
    plan.ends = degraded || (compared && image_of_cycle >= plan.images);
    return plan;
}

}  // namespace flownav::pipeline
