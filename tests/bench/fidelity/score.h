#pragma once
#include "block_score.h"
#include "ego_score.h"
#include "map_score.h"
#include "point_score.h"

namespace flownav::fidelity {

/// All figures of one drive, or summed over several.
struct Score {
    EgoScore ego;
    PointScore points;
    BlockScore blocks;
    MapScore map;

    void add(const Score& other);
};

/// Runs the chain over a drive that starts at the identity and compares it with the exact truth.
Score evaluate(const RenderedScene& drive, const config::Config& config);

}  // namespace flownav::fidelity
