#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "flownav/sim/camera_simulator.h"
#include "flownav/sim/timed_path.h"
#include "flownav/sim/wheel_odometry.h"
#include "flownav/sim/world.h"

namespace flownav {

/// Parsed command line of flownav-sim.
struct SimOptions {
    sim::World world;
    std::vector<std::string> warnings;   ///< warnings of the world file
    std::optional<sim::TimedPath> path;  ///< empty: no drive, only --write-world
    sim::CameraSimParams camera;
    sim::OdometryParams odometry;
    std::filesystem::path output;       ///< the rawlog
    std::filesystem::path write_world;  ///< empty: none
    bool quiet = false;
};

/// Parses the arguments; empty when they have been answered, with the exit status in `status`. Throws
/// ConfigError, and sim::WorldError or sim::PathError for a world or a path that cannot be read.
std::optional<SimOptions> parse_sim_options(const std::vector<std::string>& arguments, std::ostream& out,
                                            std::ostream& error, int& status);

}  // namespace flownav
