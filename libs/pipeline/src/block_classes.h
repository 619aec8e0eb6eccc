#pragma once
#include <vector>

#include "cycle.h"
#include "flownav/flow/block_layout.h"
#include "flownav/obstacles/dynamic_objects.h"
#include "flownav/pipeline/step.h"

namespace flownav::pipeline {

/// Classes of the blocks of the running cycle, one entry a block. Reused from field to field.
struct BlockClasses {
    std::vector<obstacles::Classification> of_block;
    obstacles::DynamicRegions dynamic;
    std::vector<char> moved_before;  ///< 1: dynamic at the end of the last cycle
};

/// Makes room for the blocks of a new layout.
void reset(BlockClasses& classes, std::size_t blocks);

/// Classifies every block of the running cycle: ground, obstacle, dynamic object, or of no use.
void classify(const std::vector<BlockRecord>& blocks, const Cycle& cycle, const flow::BlockLayout& layout,
              const obstacles::ObstacleParams& params, BlockClasses& classes);

/// At the end of a cycle: keeps which blocks are dynamic for the next one.
void end_cycle(BlockClasses& classes);

}  // namespace flownav::pipeline
