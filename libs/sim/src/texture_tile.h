#pragma once

#include <opencv2/core/mat.hpp>

#include "flownav/sim/world.h"

namespace flownav::sim {

/// A square piece of a surface whose opposite edges continue each other.
struct TextureTile {
    cv::Mat1b grey;
    double size_m = 1.0;  ///< of an edge
};

/// Pixels of a tile: fine for solids, large for the floor.
struct TileGrid {
    int size_px;
    double texel_m;
};
constexpr TileGrid thing_grid{600, 0.002};
constexpr TileGrid floor_grid{960, 0.0025};  // both a whole number of floor tiles

/// Draws the surface of `look`.
TextureTile texture_tile(const Look& look, const TileGrid& grid);

}  // namespace flownav::sim
