#pragma once
#include <vector>

#include "flownav/testing/scene.h"

namespace flownav::testing {

/// Poses of a drive that starts at the identity. Rounded to 1e-7, so that tables in text hold them exactly.
std::vector<Pose2> make_path(const SceneOptions& options);

}  // namespace flownav::testing
