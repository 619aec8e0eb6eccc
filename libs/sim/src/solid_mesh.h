#pragma once

#include <cstdint>
#include <vector>

#include "flownav/sim/world.h"

namespace flownav::sim {

/// A corner of a triangle: place in metres, and place on the texture in metres of surface.
struct MeshVertex {
    float x = 0.0F, y = 0.0F, z = 0.0F;
    float u = 0.0F, v = 0.0F;
};

/// Triangles, their corners counter-clockwise as seen from outside.
struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// The surface of a shape in its own frame, in flat pieces within `deviation_m` of the round surface: their
/// middles inside, their corners outside, so that things are seen in their true size.
Mesh mesh_of(const Shape& shape, double deviation_m);

}  // namespace flownav::sim
