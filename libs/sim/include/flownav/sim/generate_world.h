#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "flownav/sim/world.h"

namespace flownav::sim {

enum class WorldKind {
    Corridor,  ///< 1.8 to 2.4 m wide, two bends, boxes and poles along the walls
    Office,    ///< six rooms, doors of 1 m and more, desks, chairs with thin legs
    Hall,      ///< pillars and scattered boxes
    Forest,    ///< trunks, some of them leaning, and stumps, boulders
    Stairs,    ///< a stairwell in a room, a kerb along a corridor, or a stair down at the end of one
    Ramp,      ///< a corridor over a platform with ramps of up to 8 degrees, some with a threshold of 2 cm
};

constexpr std::array<WorldKind, 6> all_world_kinds = {WorldKind::Corridor, WorldKind::Office,
                                                      WorldKind::Hall,     WorldKind::Forest,
                                                      WorldKind::Stairs,   WorldKind::Ramp};

/// The word of a kind, as command lines have it: "corridor".
const char* to_string(WorldKind kind);

/// Draws a world. The same kind and seed give the same world. Everything is textured, see set_objects() for
/// other looks; start and goal are set, 8 to 15 m apart, and a way between them keeps 0.45 m off everything
/// that stands lower than 1 m and off every step of the ground. The start faces where there is room.
World generate_world(WorldKind kind, std::uint64_t seed);

}  // namespace flownav::sim
