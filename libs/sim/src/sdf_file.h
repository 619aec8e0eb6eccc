#pragma once

#include <filesystem>
#include <sdf/Root.hh>
#include <string>
#include <vector>

namespace flownav::sim {

struct SdfFile {
    sdf::Root root;                       ///< without actors, and without what the simulator has no use for
    std::vector<sdf::ElementPtr> actors;  ///< of the first world
    std::vector<std::string> warnings;
};

/// Reads an SDF file. The library's messages do not reach the console. Throws WorldError.
SdfFile read_sdf_file(const std::filesystem::path& file);

}  // namespace flownav::sim
