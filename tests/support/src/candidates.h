#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "raycast.h"

namespace flownav::testing {

/// A pyramid of rays from one point: everything that a tile of the image may show.
class TileFrustum {
  public:
    /// Directions of the tile's corners, in order around it.
    TileFrustum(Eigen::Vector3d origin_m, const std::array<Eigen::Vector3d, 4>& corners);

    /// False only when the solid surely lies outside.
    bool may_show(const Solid& solid) const;

  private:
    Eigen::Vector3d origin_m_;
    std::array<Eigen::Vector3d, 4> inward_;
};

std::vector<int> candidates(const std::vector<Solid>& solids, const TileFrustum& frustum);

}  // namespace flownav::testing
