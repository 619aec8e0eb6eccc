#include <cmath>
#include <limits>
#include <utility>

#include "flownav/flow/kernel.h"
#include "lidar_score.h"

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int returns_min = 3;  // minimum number of returns in a cell

/// True for the pixels that lie in a block.
class Cover {
  public:
    Cover(const flow::BlockLayout& layout, const CameraModel& camera)
        : width_px_(camera.width_px),
          height_px_(camera.height_px),
          covered_(static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px)) {
        for (const Eigen::Vector2i& corner : layout.corner_px) {
            for (int v = corner.y(); v < corner.y() + flow::block_px; ++v)
                for (int u = corner.x(); u < corner.x() + flow::block_px; ++u)
                    covered_[v * width_px_ + u] = true;
        }
    }

    bool holds(const Vector2d& pixel_px) const {
        const int u = static_cast<int>(std::lround(pixel_px.x()));
        const int v = static_cast<int>(std::lround(pixel_px.y()));
        const bool inside = u >= 0 && v >= 0 && u < width_px_ && v < height_px_;
        return inside && covered_[v * width_px_ + u];
    }

  private:
    int width_px_, height_px_;
    std::vector<bool> covered_;
};

}  // namespace

LidarView lidar_view(const std::vector<Vector3d>& scan_m, const RayMapper& mapper,
                     const flow::BlockLayout& layout, double range_max_m) {
    const CameraModel& camera = mapper.camera();
    const Cover cover(layout, camera);
    LidarView view;
    std::map<std::pair<int, int>, int> returns;
    for (const Vector3d& at_m : scan_m) {
        if (at_m.z() < obstacle_low_m) continue;
        view.high_m.emplace_back(at_m.head<2>());
        const double range_m = std::hypot(at_m.x() - camera.mount.forward_m, at_m.y() - camera.mount.left_m);
        if (at_m.z() > obstacle_high_m || range_m > range_max_m || !cover.holds(project(mapper, at_m)))
            continue;
        const Vector2d cell = (at_m.head<2>() / lidar_cell_m).array().floor();
        ++returns[{static_cast<int>(cell.x()), static_cast<int>(cell.y())}];
    }
    for (const auto& [cell, count] : returns) {
        if (count < returns_min) continue;
        view.cells_m.emplace_back((cell.first + 0.5) * lidar_cell_m, (cell.second + 0.5) * lidar_cell_m);
    }
    return view;
}

double nearest_m(const std::vector<Vector2d>& places_m, const Vector2d& at_m) {
    double nearest2 = std::numeric_limits<double>::infinity();
    for (const Vector2d& place_m : places_m) nearest2 = std::min(nearest2, (place_m - at_m).squaredNorm());
    return std::sqrt(nearest2);
}

}  // namespace flownav::fidelity
