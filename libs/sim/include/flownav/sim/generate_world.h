#pragma once

#include <cstdint>
#include <string>

#include "flownav/sim/world.h"

namespace flownav::sim {

enum class WorldKind {
    Corridor,  ///< 1.8 to 2.4 m wide, two bends, boxes and poles along the walls
    Office,    ///< six rooms, doors of 1 m and more, desks, chairs with thin legs
    Hall,      ///< pillars and scattered boxes
    Forest,    ///< trunks, some of them leaning, and stumps, boulders
};

/// The word of a kind, as command lines have it: "corridor".
const char* to_string(WorldKind kind);

/// Draws a world. The same kind and seed give the same world. Everything is textured; start and goal are set,
/// 8 to 15 m apart, and a way between them keeps 0.45 m off everything that stands lower than 1 m. The start
/// faces where there is room.
World generate_world(WorldKind kind, std::uint64_t seed);

}  // namespace flownav::sim
