#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flownav/sim/world.h"

namespace flownav::sim {

/// Look of everything that stands on the floor.
enum class ObjectLook : std::uint8_t {
    Real,       ///< as in real rooms: see furnish_as_real()
    Patterned,  ///< rich texture
    Faint,      ///< low contrast
    Plain,      ///< one grey each
};

/// The words of command lines: real, patterned, faint, plain.
const char* to_string(ObjectLook look);

/// Changes the look of all solids but lamps.
void set_objects(World& world, ObjectLook look, std::uint64_t seed);

/// Makes a textured world look like real rooms: every solid has one grey. In a world with walls a third of
/// them get skirting boards, some a door with a frame; tape, paper and one-colour mats lie on the floor;
/// lamps shine in it, and shadows are soft. In a world without walls shadows are those of the sun. The same
/// seed gives the same world.
void furnish_as_real(World& world, std::uint64_t seed);

/// Surfaces of floors by the words of command lines: carpet, tiles, lino, plain, stoneware, marbled.
const std::vector<std::pair<std::string, Surface>>& floor_surfaces();

}  // namespace flownav::sim
