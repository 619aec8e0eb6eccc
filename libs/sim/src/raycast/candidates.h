#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "cast.h"

namespace flownav::sim {

/// Pyramid of all rays of a tile of the image.
class TileFrustum {
  public:
    /// Directions of the tile's corners, in order around it.
    TileFrustum(Eigen::Vector3d origin_m, const std::array<Eigen::Vector3d, 4>& corners);

    /// False only when the solid surely lies outside.
    bool may_show(const PlacedSolid& solid) const;

  private:
    Eigen::Vector3d origin_m_;
    std::array<Eigen::Vector3d, 4> inward_;
};

/// Indices of the visible solids that the tile may show.
std::vector<int> candidates(const std::vector<PlacedSolid>& solids, const TileFrustum& frustum);

}  // namespace flownav::sim
