#pragma once
#include <filesystem>
#include <string>

#include "flownav/testing/scene.h"

namespace flownav::testing {

/// basename + suffix; a dot in the base name stays.
std::filesystem::path with_suffix(const std::filesystem::path& basename, const std::string& suffix);

void write_ground_truth_csv(const Scene& scene, const std::filesystem::path& file);
void write_objects_csv(const Scene& scene, const std::filesystem::path& file);

/// Position per image of the last solid, which is the one that moves; no file when it rests.
void write_movers_csv(const Scene& scene, const std::filesystem::path& file);

}  // namespace flownav::testing
