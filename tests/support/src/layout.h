#pragma once
#include <vector>

#include "flownav/testing/scene.h"

namespace flownav::testing {

/// The ground and everything that stands on it along a path.
World make_world(const SceneOptions& options, const std::vector<Pose2>& path);

}  // namespace flownav::testing
