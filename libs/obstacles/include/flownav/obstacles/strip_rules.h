#pragma once
#include <vector>

#include "flownav/obstacles/contact_scanner.h"

namespace flownav::obstacles {

/// Sets floor_end_m of every strip: confirmed floor from the lower border of the image up, until it is
/// interrupted or the texture that other strips show in the same rows is missing.
/// `map`: buffer, filled.
void find_floor_ends(const LevelImage& image, const std::vector<FloorCell>& cells, FloorMap& map,
                     std::vector<StripEvidence>& strips);

/// Sets wall_m of every strip by the static rule: what has no edge from above the horizon down to its first
/// edge is no floor, nor what begins near by where the floor ends and hides floor that other strips show.
/// Needs floor ends and votes.
void find_walls(const LevelImage& image, const std::vector<FloorCell>& cells, const FloorMap& map,
                double range_max_m, std::vector<StripEvidence>& strips);

}  // namespace flownav::obstacles
