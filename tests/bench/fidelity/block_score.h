#pragma once
#include <array>
#include <map>

#include "chain_run.h"
#include "ego_score.h"
#include "flownav/testing/upright.h"
#include "statistics.h"

namespace flownav::fidelity {

/// Upper limits of the ranges of the detection table, metres.
constexpr std::array<double, 5> range_ends_m = {1.5, 2.0, 3.0, 4.0, 8.0};

/// Classification of blocks as obstacles against the exact flow, over one or several drives.
struct BlockScore {
    Share detected;  ///< detected share of the blocks whose true value of (13) exceeds tau by half a pixel
    Share detected_textured;  ///< the part of `detected` that shows richly textured objects
    std::map<BlockLabel, std::int64_t> labels;  ///< labels of the blocks of `detected`
    std::map<BlockLabel, std::int64_t> fates_textured;  ///< labels of the blocks of `detected_textured`
    Share false_blocks;  ///< blocks labelled as obstacles that show only floor, per cycle
    std::map<sim::ThingKind, std::array<Share, range_ends_m.size()>> by_kind;  ///< parts of `detected`

    void add(const BlockScore& other);
};

class BlockWatcher {
  public:
    void see(const Moment& moment);
    const BlockScore& result() const { return score_; }

  private:
    void see_block(const Moment& moment, const pipeline::BlockRecord& block);

    BlockScore score_;
};

}  // namespace flownav::fidelity
