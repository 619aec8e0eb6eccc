#pragma once
#include <vector>

#include "flownav/core/camera_model.h"
#include "flownav/core/obstacle_point.h"
#include "flownav/core/virtual_scan.h"
#include "flownav/obstacles/params.h"

namespace flownav::obstacles {

/// An empty scan that covers the camera's horizontal view in beams of params.beam_deg; all beams Unknown.
VirtualScan scan_layout(const RayMapper& mapper, const ObstacleParams& params);

/// Fills the beams of `scan` anew: the nearest obstacle of each bearing; else free as far as confirmed floor
/// reaches without a gap of more than half a metre; else Unknown. `patches` is sorted by this function.
void fill_scan(VirtualScan& scan, const std::vector<ObstaclePoint>& points,
               std::vector<GroundPatch>& patches);

}  // namespace flownav::obstacles
