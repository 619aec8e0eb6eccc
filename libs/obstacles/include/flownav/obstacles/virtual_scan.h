#pragma once
#include <vector>

#include "flownav/core/camera_model.h"
#include "flownav/core/contact_scan.h"
#include "flownav/core/obstacle_point.h"
#include "flownav/core/virtual_scan.h"
#include "flownav/obstacles/params.h"

namespace flownav::obstacles {

/// Returns a scan that covers the camera's horizontal view in beams of params.beam_deg; all beams are
/// Unknown.
VirtualScan scan_layout(const RayMapper& mapper, const ObstacleParams& params);

/// Overwrites the beams of `scan`: Obstacle at the nearest obstacle of the bearing; else Free as far as
/// confirmed floor reaches without a gap of more than 0.5 m; else Unknown. Sorts `patches` by distance.
void fill_scan(VirtualScan& scan, const std::vector<ObstaclePoint>& points,
               std::vector<GroundPatch>& patches);

/// Adds the contacts and the floor of a contact scan: a beam ends at the nearest obstacle, and is free as far
/// as either tells. Does nothing when the gate is closed.
void add_contacts(VirtualScan& scan, const ContactScan& contacts);

}  // namespace flownav::obstacles
