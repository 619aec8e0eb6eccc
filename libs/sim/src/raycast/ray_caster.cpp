#include "flownav/sim/ray_caster.h"

#include <algorithm>
#include <utility>

#include "painter.h"

namespace flownav::sim {
namespace {

constexpr int tile_px = 16;

}  // namespace

cv::Mat1f cast_light(const World& world, const View& view) {
    const ScenePainter painter(world, view);
    cv::Mat1f light(painter.height(), painter.width());
    const int columns = (painter.width() + tile_px - 1) / tile_px;
    const int rows = (painter.height() + tile_px - 1) / tile_px;
#pragma omp parallel for schedule(dynamic)
    for (int tile = 0; tile < columns * rows; ++tile) {
        const int u = tile % columns * tile_px;
        const int v = tile / columns * tile_px;
        painter.paint_tile(u, v, std::min(u + tile_px, painter.width()),
                           std::min(v + tile_px, painter.height()), light);
    }
    return light;
}

RayCaster::RayCaster(World world, const CameraModel& camera) : world_(std::move(world)), camera_(camera) {}

cv::Mat1b RayCaster::render(const Pose2& T_world_robot, double time_s) {
    cv::Mat1b picture;
    cast_light(world_, on_ground(world_, {camera_, T_world_robot, time_s})).convertTo(picture, CV_8U);
    return picture;
}

cv::Mat1f RayCaster::depth_m(const Pose2& T_world_robot, double time_s) {
    const View view = on_ground(world_, {camera_, T_world_robot, time_s});
    const RayFrame frame(view);
    const RayMapper mapper(camera_);
    const Ground ground(world_);
    const std::vector<PlacedSolid> solids = solids_at(world_, time_s);
    const std::vector<int> visible = visible_of(solids);
    const Eigen::Matrix3d R_mounted_level = level_rotation(camera_.mount).transpose();
    cv::Mat1f depth(camera_.height_px, camera_.width_px, 0.0F);
    for (int v = 0; v < depth.rows; ++v) {
        for (int u = 0; u < depth.cols; ++u) {
            const Eigen::Vector2d level_ray = mapper.ray(Eigen::Vector2d(u, v));
            const Hit hit = cast(solids, ground, visible, {frame.origin_m, frame.direction(level_ray)});
            if (hit.solid == no_surface) continue;
            const double share = (R_mounted_level * level_ray.homogeneous()).z();
            depth(v, u) = static_cast<float>(hit.t * share);
        }
    }
    return depth;
}

}  // namespace flownav::sim
