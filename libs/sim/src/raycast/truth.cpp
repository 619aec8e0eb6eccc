#include "flownav/sim/truth.h"

#include "cast.h"
#include "flownav/sim/ground.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Hit cast_all(const World& world, const View& view, const Ray& ray) {
    const std::vector<PlacedSolid> solids = solids_at(world, view.time_s);
    return cast(solids, Ground(world), visible_of(solids), ray);
}

bool inside(const CameraModel& camera, const Vector2d& pixel_px) {
    return pixel_px.x() >= -0.5 && pixel_px.y() >= -0.5 && pixel_px.x() < camera.width_px - 0.5 &&
           pixel_px.y() < camera.height_px - 0.5;
}

/// Whether a surface stands between the camera and a point of the world frame.
bool hidden(const World& world, const View& view, const Vector3d& point_m) {
    const RayFrame frame(view);
    const Vector3d direction = point_m - frame.origin_m;
    return cast_all(world, view, {frame.origin_m, direction}).t < 1.0 - 1e-6;
}

/// The point of a solid at `from_s`, where it is at `to_s`.
Vector3d carried(const Solid& solid, const Vector3d& point_m, double from_s, double to_s) {
    if (solid.script.empty()) return point_m;
    return pose_at(solid, to_s) * (pose_at(solid, from_s).inverse() * point_m);
}

}  // namespace

View on_ground(const World& world, View view) {
    view.T_flat_robot = ride_on_ground(world, view.T_world_robot);
    return view;
}

std::optional<Sight> look(const World& world, const View& view, const Vector2d& pixel_px) {
    const RayFrame frame(view);
    const Ray ray{frame.origin_m, frame.direction(RayMapper(view.camera).ray(pixel_px))};
    const Hit hit = cast_all(world, view, ray);
    if (hit.solid == no_surface) return std::nullopt;
    const int object = hit.solid < 0 ? 0 : world.solids[static_cast<std::size_t>(hit.solid)].object;
    return Sight{hit.solid, object, hit.t, ray.origin_m + hit.t * ray.direction};
}

std::optional<Vector2d> project(const View& view, const Vector3d& point_m) {
    const RayFrame frame(view);
    const Vector3d d = point_m - frame.origin_m;
    const double depth = d.dot(frame.forward);
    if (depth <= 1e-6) return std::nullopt;
    return RayMapper(view.camera).pixel(Vector2d(d.dot(frame.right), d.dot(frame.down)) / depth);
}

std::optional<FlowTruth> exact_flow(const World& world, const View& from, const View& to,
                                    const Vector2d& pixel_px) {
    const std::optional<Sight> sight = look(world, from, pixel_px);
    if (!sight) return std::nullopt;
    Vector3d point = sight->point_m;
    if (sight->solid >= 0)
        point = carried(world.solids[static_cast<std::size_t>(sight->solid)], point, from.time_s, to.time_s);
    const std::optional<Vector2d> pixel = project(to, point);
    if (!pixel) return std::nullopt;
    return FlowTruth{*pixel - pixel_px, *sight, inside(to.camera, *pixel), hidden(world, to, point)};
}

}  // namespace flownav::sim
