#pragma once

#include <vector>

#include "contact_scene.h"
#include "flownav/config/config.h"

namespace flownav::contact_bench {

/// The contact scan against the exact world, over several drives.
struct Score {
    int passes = 0;      ///< things that stayed in view at 1 to 3 m for three scans or more
    int missed = 0;      ///< of these: never had a contact within 0.2 m
    int seen = 0;        ///< things in view at 1 to 3 m, summed over the scans
    int hit = 0;         ///< of these: with a contact within 0.2 m in this scan
    int points_hit = 0;  ///< of these: with an obstacle point of the blocks within 0.2 m
    int scans = 0;
    int closed = 0;                   ///< cycles whose gate was closed, by PoorFloor
    int false_strips = 0;             ///< contacts far from any surface: more than max(0.3 m, 12 %)
    int gross_strips = 0;             ///< more than 0.5 m and 25 %
    int facing = 0;                   ///< strips that face a thing nearer than 3 m
    int wrong_free = 0;               ///< of these: free beyond the thing
    int strips = 0;                   ///< within 40 degrees of the heading
    int decided = 0;                  ///< of these: decided up to 2 m
    std::vector<double> range_error;  ///< relative, of contacts at 1 to 3 m
    double vignetting = 0.0;          ///< sum over the scans
    double fit_share = 0.0;           ///< the same

    void add(const Score& other);
};

Score evaluate(const RecordedScene& scene, const config::Config& config);

}  // namespace flownav::contact_bench
