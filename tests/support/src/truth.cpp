#include "flownav/testing/truth.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "raycast.h"

namespace flownav::testing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Hit cast_all(const World& world, const View& view, const Ray& ray) {
    const std::vector<Solid> solids = solids_of(world, view.time_s);
    std::vector<int> all(solids.size());
    std::iota(all.begin(), all.end(), 0);
    return cast(solids, Floor(world.waves), all, ray);
}

bool inside(const CameraModel& camera, const Vector2d& pixel_px) {
    return pixel_px.x() >= -0.5 && pixel_px.y() >= -0.5 && pixel_px.x() < camera.width_px - 0.5 &&
           pixel_px.y() < camera.height_px - 0.5;
}

/// Whether something stands between the camera and a point that it would see at `pixel_px`.
bool hidden(const World& world, const View& view, const Vector3d& point_m) {
    const RayFrame frame(view);
    const Vector3d direction = point_m - frame.origin_m;
    return cast_all(world, view, {frame.origin_m, direction}).t < 1.0 - 1e-6;
}

}  // namespace

std::optional<Sight> look(const World& world, const View& view, const Vector2d& pixel_px) {
    const RayFrame frame(view);
    const Ray ray{frame.origin_m, frame.direction(RayMapper(view.camera).ray(pixel_px))};
    const Hit hit = cast_all(world, view, ray);
    if (hit.primitive == nothing) return std::nullopt;
    const bool ground = hit.primitive == ground_primitive;
    const int object = ground ? 0 : world.primitives[static_cast<std::size_t>(hit.primitive)].object;
    return Sight{hit.primitive, object, hit.t, ray.origin_m + hit.t * ray.direction};
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
    if (sight->primitive >= 0) {
        const Primitive& p = world.primitives[static_cast<std::size_t>(sight->primitive)];
        point.head<2>() += (to.time_s - from.time_s) * p.velocity_mps;
    }
    const std::optional<Vector2d> pixel = project(to, point);
    if (!pixel) return std::nullopt;
    return FlowTruth{*pixel - pixel_px, *sight, inside(to.camera, *pixel), hidden(world, to, point)};
}

EgoMotion exact_motion(const Pose2& from, const Pose2& to) {
    const Pose2 T_from_to = compose(inverse(from), to);
    EgoMotion motion;
    motion.omega_rad = T_from_to.yaw_rad;
    motion.forward_m =
        T_from_to.x_m * std::cos(T_from_to.yaw_rad / 2) + T_from_to.y_m * std::sin(T_from_to.yaw_rad / 2);
    motion.omega_measured = motion.forward_measured = true;
    return motion;
}

EgoMotion exact_motion(const View& from, const View& to) {
    EgoMotion motion = exact_motion(from.T_world_robot, to.T_world_robot);
    motion.pitch_rad = from.camera.mount.pitch_rad - to.camera.mount.pitch_rad;
    return motion;
}

}  // namespace flownav::testing
