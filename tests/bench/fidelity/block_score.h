#pragma once
#include <array>
#include <map>

#include "chain_run.h"
#include "ego_score.h"
#include "flownav/testing/world.h"
#include "statistics.h"

namespace flownav::fidelity {

/// Upper ends of the ranges that detection is told by, metres.
constexpr std::array<double, 5> range_ends_m = {1.5, 2.0, 3.0, 4.0, 8.0};

/// Blocks as obstacles or not, against the exact flow, over one or several drives.
struct BlockScore {
    Share detected;           ///< of the blocks whose true value of (13) exceeds tau by half a pixel
    Share detected_textured;  ///< the part of them that looks at richly textured things
    std::map<BlockLabel, std::int64_t> labels;           ///< what became of them
    std::map<BlockLabel, std::int64_t> fates_textured;  ///< what became of that part
    Share false_blocks;                                ///< obstacles that show nothing but floor, per cycle
    std::map<testing::ThingKind, std::array<Share, range_ends_m.size()>> by_kind;  ///< parts of `detected`

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
