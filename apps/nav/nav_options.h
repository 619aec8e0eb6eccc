#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "flownav/drive/simulated_drive.h"
#include "flownav/io/producer_settings.h"

namespace flownav {

/// What flownav-nav was asked for.
struct NavOptions {
    std::string robot = "sim";                   ///< sim, or tcp:HOST:PORT
    std::optional<io::ProducerSettings> camera;  ///< of a real robot
    drive::SimulatedDriveOptions drive;          ///< of a real robot: only what is no simulation
    std::filesystem::path output;                ///< folder of pictures, logs and report; empty: none
    std::filesystem::path result;                ///< empty: the output folder's result.json, if there is one
    std::filesystem::path record;                ///< a rawlog; empty: none
    std::filesystem::path picture;               ///< empty: the output folder's drive.png, if there is one
    double reference_path_m = 0.0;               ///< of the score; 0: no score
    std::uint64_t seed = 1;
    bool quiet = false;
};

extern const char* const nav_help;

/// What the arguments ask for, or nothing when they have been answered; then `status` says how. Throws
/// ConfigError, and std::runtime_error for a world or a list of way points that cannot be read.
std::optional<NavOptions> parse_nav_options(const std::vector<std::string>& arguments, std::ostream& out,
                                            std::ostream& error, int& status);

}  // namespace flownav
