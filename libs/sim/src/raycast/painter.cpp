#include "painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int edge_rays = 6;  ///< per axis, in pixels that show more than one surface

bool same_surface(const Hit& a, const Hit& b) {
    return a.solid == b.solid && a.face == b.face && a.piece == b.piece;
}

/// Place of (u, v) in an array of rows of `columns`.
std::size_t index_of(int u, int v, int columns) {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(u);
}

/// Reach of a tile's frustum beyond its border.
constexpr int margin_px = 1;

std::vector<Vector2d> corner_rays(const CameraModel& camera) {
    const RayMapper mapper(camera);
    const int columns = camera.width_px + 1;
    const int rows = camera.height_px + 1;
    std::vector<Vector2d> rays(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
#pragma omp parallel for schedule(static)
    for (int v = 0; v < rows; ++v) {
        for (int u = 0; u < columns; ++u) {
            rays[index_of(u, v, columns)] = mapper.ray(Vector2d(u - 0.5, v - 0.5));
        }
    }
    return rays;
}

}  // namespace

ScenePainter::ScenePainter(const World& world, const View& view)
    : width_(view.camera.width_px),
      height_(view.camera.height_px),
      sky_grey_(world.sky_grey),
      shading_(world.shading),
      frame_(view),
      ground_(world),
      pieces_(world.ground),
      floor_light_(world, view.T_world_robot, view.time_s, frame_.origin_m),
      solids_(solids_at(world, view.time_s)),
      corners_(corner_rays(view.camera)) {
    for (const Solid& s : world.solids) samplers_.emplace_back(s.look);
    samplers_.emplace_back(world.floor);
    for (const GroundPiece& piece : world.ground) {
        tops_.emplace_back(piece.look);
        walls_.emplace_back(wall_look(piece));
    }
}

const Vector2d& ScenePainter::corner(int u, int v) const {
    return corners_[index_of(u, v, width_ + 1)];
}

Hit ScenePainter::hit_at(const std::vector<int>& tile, const Vector2d& level_ray) const {
    return cast(solids_, ground_, tile, {frame_.origin_m, frame_.direction(level_ray)});
}

std::vector<int> ScenePainter::tile_candidates(int u0, int v0, int u1, int v1) const {
    const int left = std::max(0, u0 - margin_px);
    const int right = std::min(width_, u1 + margin_px);
    const int top = std::max(0, v0 - margin_px);
    const int bottom = std::min(height_, v1 + margin_px);
    const TileFrustum frustum(
        frame_.origin_m, {frame_.direction(corner(left, top)), frame_.direction(corner(right, top)),
                          frame_.direction(corner(right, bottom)), frame_.direction(corner(left, bottom))});
    return candidates(solids_, frustum);
}

void ScenePainter::paint_tile(int u0, int v0, int u1, int v1, cv::Mat1f& light) const {
    const std::vector<int> tile = tile_candidates(u0, v0, u1, v1);
    const int columns = u1 - u0 + 1;
    std::vector<Hit> hits;
    for (int v = v0; v <= v1; ++v)
        for (int u = u0; u <= u1; ++u) hits.push_back(hit_at(tile, corner(u, v)));
    const auto at = [&](int u, int v) -> const Hit& { return hits[index_of(u - u0, v - v0, columns)]; };
    for (int v = v0; v < v1; ++v) {
        for (int u = u0; u < u1; ++u) {
            const Hit& first = at(u, v);
            const bool uniform = same_surface(first, at(u + 1, v)) && same_surface(first, at(u, v + 1)) &&
                                 same_surface(first, at(u + 1, v + 1));
            light(v, u) = static_cast<float>(pixel(tile, u, v, uniform));
        }
    }
}

double ScenePainter::pixel(const std::vector<int>& tile, int u, int v, bool uniform) const {
    const Vector2d right = 0.5 * (corner(u + 1, v) + corner(u + 1, v + 1) - corner(u, v) - corner(u, v + 1));
    const Vector2d down = 0.5 * (corner(u, v + 1) + corner(u + 1, v + 1) - corner(u, v) - corner(u + 1, v));
    const Vector2d middle =
        0.25 * (corner(u, v) + corner(u + 1, v) + corner(u, v + 1) + corner(u + 1, v + 1));
    const int n = uniform ? 1 : edge_rays;
    double sum = 0.0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const Vector2d ray = middle + ((i + 0.5) / n - 0.5) * right + ((j + 0.5) / n - 0.5) * down;
            sum += shade(hit_at(tile, ray), ray, right / n, down / n);
        }
    }
    return sum / (n * n);
}

/// Share of the light on a face. It comes from above and the left: a face keeps its brightness while the
/// robot moves.
double ScenePainter::light_on(const Vector3d& normal) const {
    const Vector3d towards_light = Vector3d(-0.35, 0.45, 0.82).normalized();
    return (1.0 - shading_) + shading_ * std::max(0.0, normal.dot(towards_light)) / towards_light.z();
}

const TextureSampler& ScenePainter::sampler_of(const Hit& hit) const {
    if (hit.solid >= 0) return samplers_[static_cast<std::size_t>(hit.solid)];
    if (hit.piece == bare_floor) return samplers_.back();
    return (hit.face == Top ? tops_ : walls_)[static_cast<std::size_t>(hit.piece)];
}

double ScenePainter::shade(const Hit& hit, const Vector2d& level_ray, const Vector2d& right,
                           const Vector2d& down) const {
    if (hit.solid == no_surface) return sky_grey_;
    const Vector3d direction = frame_.direction(level_ray);
    const Tangent tangent = tangent_at(solids_, pieces_, hit, frame_.origin_m + hit.t * direction);
    const double facing = std::min(tangent.normal.dot(direction), -0.02);
    // Motion of the point on the tangent plane when the ray turns by a pixel.
    const auto on_surface = [&](const Vector2d& step) {
        const Vector3d turn = step.x() * frame_.right + step.y() * frame_.down;
        const Vector3d moved = hit.t * (turn - direction * (tangent.normal.dot(turn) / facing));
        return Vector2d(tangent.u_axis.dot(moved), tangent.v_axis.dot(moved));
    };
    const TextureFootprint footprint{tangent.uv_m, on_surface(right), on_surface(down)};
    const double grey = light_on(tangent.normal) * sampler_of(hit).grey(footprint);
    const Vector3d at_m = frame_.origin_m + hit.t * direction;
    if (floor_light_.empty() || hit.piece != bare_floor || at_m.z() > mark_height_m ||
        tangent.normal.z() < 0.99)
        return grey;
    return floor_light_.lit(grey, at_m.head<2>(), footprint.right_m, footprint.down_m);
}

}  // namespace flownav::sim
