#pragma once
#include <optional>
#include <string>
#include <vector>

#include "flownav/testing/scene.h"

namespace flownav::testing {

/// A scene with a name: what makes it hard, in one line.
struct Preset {
    const char* name;
    const char* meaning;
    void (*apply)(SceneOptions& options);  ///< on top of common_preset()
};

/// What all presets share: 200 images of 640x480 at 25 Hz and 0.4 m/s, a weave of up to 20 deg/s on carpet
/// past rails, chairs, 5 cm poles, 15 cm boxes, drums and boxes within four walls; noise of 2.5 grey levels.
SceneOptions common_preset(std::uint64_t seed);

const std::vector<Preset>& all_presets();

/// The options of a named scene; nothing when there is none of that name.
std::optional<SceneOptions> preset(const std::string& name, std::uint64_t seed);

}  // namespace flownav::testing
