#pragma once
#include <vector>

#include "block_classes.h"
#include "flownav/core/contact_scan.h"
#include "flownav/core/virtual_scan.h"
#include "measure.h"

namespace flownav::pipeline {

/// The surroundings at the end of a cycle, in the robot frame of its last field. Reused from cycle to cycle.
struct Reconstruction {
    std::vector<ObstaclePoint> obstacles;
    std::vector<GroundPatch> ground;
    VirtualScan scan;
};

/// A cycle that ends: its blocks and their classes, its images, its first and its last field.
struct EndedCycle {
    const std::vector<BlockRecord>& blocks;
    const BlockClasses& classes;
    const Cycle& images;
    const ReferenceImage& reference;
    const ReferenceImage& newest;
    const ContactScan& contacts;  ///< the last scan, seen from the robot frame of `newest`
};

/// Fills `out`: 3D points, confirmed floor and the virtual scan. `out.scan` has the beams of scan_layout().
void reconstruct(const EndedCycle& cycle, const obstacles::ObstacleParams& params, Reconstruction& out);

}  // namespace flownav::pipeline
