#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "flownav/testing/scene.h"

namespace flownav::fidelity {

/// A drive with all its images in memory.
struct RenderedScene {
    std::string name;
    testing::Scene scene;
    std::vector<Field> fields;
    bool wheels = false;  ///< the chain also gets the wheel odometry of the robot, with its usual errors
};

/// Renders a scene, or reads its images from `cache` (a folder; empty: none) when they match. Throws
/// std::runtime_error when the cache cannot be written.
RenderedScene render_scene(const std::string& name, const testing::SceneOptions& options,
                           const std::filesystem::path& cache = {});

/// Renders a hand-made scene, or reads its images from `cache`.
RenderedScene render_scene(const std::string& name, const testing::Scene& scene,
                           const std::filesystem::path& cache = {});

}  // namespace flownav::fidelity
