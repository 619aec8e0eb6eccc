#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "flownav/sim/world.h"

namespace flownav::sim {

/// A world's file that cannot be used; the message names the file, and the line where it is known.
class WorldError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct LoadedWorld {
    World world;
    std::vector<std::string> warnings;  ///< what the file asks for and is left out, a line each
};

/// Reads the first world of an SDF file, as Gazebo has them: boxes, cylinders and spheres of models and
/// actors, the ground plane, the frames `start` and `goal`. Solids keep the order of the file. `state`,
/// `include` and all else is left out; see share/doc/simulator.md. Throws WorldError when there is no such
/// file, no world in it, or something in it cannot be read.
LoadedWorld read_sdf_world(const std::filesystem::path& file);

/// The text of an SDF file that read_sdf_world() reads as the same world; poses are rounded to 1e-9 m and
/// rad.
std::string to_sdf(const World& world);

}  // namespace flownav::sim
