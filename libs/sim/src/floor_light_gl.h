#pragma once

#include <array>

#include "raycast/floor_light.h"

namespace flownav::sim {

/// Draws shadows and reflections over a floor that OpenGL has drawn before. Its names in OpenGL die with the
/// context.
class FloorLightPainter {
  public:
    /// `pmv`: from the world frame to clip coordinates, in the order of columns. Needs a bound vertex array
    /// and leaves another program in use. Throws std::runtime_error when the driver refuses the shaders.
    void paint(const FloorLight& light, const std::array<float, 16>& pmv);

  private:
    unsigned int shadow_program_ = 0;
    unsigned int spot_program_ = 0;
};

}  // namespace flownav::sim
