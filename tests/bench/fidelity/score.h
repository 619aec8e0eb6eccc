#pragma once
#include "block_score.h"
#include "ego_score.h"
#include "map_score.h"
#include "point_score.h"

namespace flownav::fidelity {

/// All figures of a drive, or of several drives added up.
struct Score {
    EgoScore ego;
    PointScore points;
    BlockScore blocks;
    MapScore map;

    void add(const Score& other);
};

/// Runs the chain over a drive that starts at the identity and compares with the exact truth.
Score evaluate(const RenderedScene& drive, const config::Config& config);

}  // namespace flownav::fidelity
