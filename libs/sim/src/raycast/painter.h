#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "candidates.h"
#include "floor_light.h"
#include "flownav/sim/surface_texture.h"

namespace flownav::sim {

/// Light of the world as a view sees it, before the camera's electronics.
class ScenePainter {
  public:
    ScenePainter(const World& world, const View& view);

    /// Paints pixels [u0, u1) x [v0, v1) into `light` (the whole image), grey levels.
    void paint_tile(int u0, int v0, int u1, int v1, cv::Mat1f& light) const;

    int width() const { return width_; }
    int height() const { return height_; }

  private:
    const Eigen::Vector2d& corner(int u, int v) const;
    Hit hit_at(const std::vector<int>& tile, const Eigen::Vector2d& level_ray) const;
    std::vector<int> tile_candidates(int u0, int v0, int u1, int v1) const;
    double pixel(const std::vector<int>& tile, int u, int v, bool uniform) const;
    double light_on(const Eigen::Vector3d& normal) const;
    const TextureSampler& sampler_of(const Hit& hit) const;
    double shade(const Hit& hit, const Eigen::Vector2d& level_ray, const Eigen::Vector2d& right,
                 const Eigen::Vector2d& down) const;

    int width_, height_;
    double sky_grey_, shading_;
    RayFrame frame_;
    Ground ground_;
    std::vector<GroundPiece> pieces_;
    FloorLight floor_light_;
    std::vector<PlacedSolid> solids_;
    std::vector<TextureSampler> samplers_;  ///< of the solids; the floor's comes last
    std::vector<TextureSampler> tops_;      ///< of the pieces of ground
    std::vector<TextureSampler> walls_;
    std::vector<Eigen::Vector2d> corners_;  ///< level rays of the pixels' corners
};

}  // namespace flownav::sim
