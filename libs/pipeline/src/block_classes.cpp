#include "block_classes.h"

namespace flownav::pipeline {

void reset(BlockClasses& classes, std::size_t blocks) {
    classes.of_block.resize(blocks);
    classes.moved_before.assign(blocks, 0);
}

void classify(const std::vector<BlockRecord>& blocks, const Cycle& cycle, const flow::BlockLayout& layout,
              const obstacles::ObstacleParams& params, BlockClasses& classes) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const BlockRecord& block = blocks[i];
        obstacles::Classification& c = classes.of_block[i];
        c = {};
        c.label = block.label;
        if (block.image_of_cycle == 0) continue;
        const ImageOfCycle& image = cycle[block.image_of_cycle - 1];
        c = obstacles::classify(image.derotation(block.ray), image.classifier, params);
        c.drift /= block.image_of_cycle;
        c.drift_sigma /= block.image_of_cycle;
    }
    obstacles::mark_dynamic_objects(classes.of_block, layout.neighbours, classes.dynamic);
    obstacles::confirm_by_neighbours(classes.of_block, layout.neighbours, params);
}

void end_cycle(BlockClasses& classes) {
    for (std::size_t i = 0; i < classes.moved_before.size(); ++i)
        classes.moved_before[i] = classes.dynamic.region_of[i] >= 0;
}

}  // namespace flownav::pipeline
