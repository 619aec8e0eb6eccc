#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "flownav/testing/scene.h"

namespace flownav::fidelity {

/// A drive with all its pictures in memory.
struct RenderedScene {
    std::string name;
    testing::Scene scene;
    std::vector<Field> fields;
};

/// Renders a scene, or reads its pictures from `cache` (a folder; empty: none) when they are of this very
/// scene. Throws std::runtime_error when the cache cannot be written.
RenderedScene render_scene(const std::string& name, const testing::SceneOptions& options,
                           const std::filesystem::path& cache = {});

/// The same for a scene that was made by hand.
RenderedScene render_scene(const std::string& name, const testing::Scene& scene,
                           const std::filesystem::path& cache = {});

}  // namespace flownav::fidelity
