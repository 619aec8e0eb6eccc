#include "depth_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "flownav/sim/plan_view.h"
#include "raycast/ground.h"

namespace flownav::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nothing = std::numeric_limits<double>::infinity();

/// Both in the frame of a shape; `along` has depth 1, so that lengths along the ray are depths.
struct LocalRay {
    Vector3d from;
    Vector3d along;
};

struct Interval {
    double enter = -nothing;
    double leave = nothing;

    /// Narrows to where `from + t along` lies within +-half.
    void clip(double from, double along, double half) {
        if (along == 0.0) {
            if (std::abs(from) > half) leave = -nothing;
            return;
        }
        const double a = (-half - from) / along;
        const double b = (half - from) / along;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    double nearest() const { return enter <= leave && enter > 0.0 ? enter : nothing; }
};

/// Where |p + t d| = radius.
Interval chord(double pp, double pd, double dd, double radius) {
    const double root = pd * pd - dd * (pp - radius * radius);
    if (root < 0.0 || dd == 0.0) {
        if (root >= 0.0 && pp <= radius * radius) return {};
        return {nothing, -nothing};
    }
    return {(-pd - std::sqrt(root)) / dd, (-pd + std::sqrt(root)) / dd};
}

double depth_of(const Box& box, const LocalRay& ray) {
    Interval t;
    for (int axis = 0; axis < 3; ++axis) t.clip(ray.from[axis], ray.along[axis], box.size_m[axis] / 2);
    return t.nearest();
}

double depth_of(const Cylinder& cylinder, const LocalRay& ray) {
    const Vector2d p = ray.from.head<2>();
    const Vector2d d = ray.along.head<2>();
    Interval t = chord(p.squaredNorm(), p.dot(d), d.squaredNorm(), cylinder.radius_m);
    t.clip(ray.from.z(), ray.along.z(), cylinder.length_m / 2);
    return t.nearest();
}

double depth_of(const Sphere& sphere, const LocalRay& ray) {
    return chord(ray.from.squaredNorm(), ray.from.dot(ray.along), ray.along.squaredNorm(), sphere.radius_m)
        .nearest();
}

/// Rays of all pixels in the camera's frame, with z = 1.
cv::Mat3d rays_of(const CameraModel& camera) {
    CameraModel level = camera;
    level.mount = {};
    const RayMapper mapper(level);
    cv::Mat3d rays(camera.height_px, camera.width_px);
    for (int v = 0; v < camera.height_px; ++v) {
        for (int u = 0; u < camera.width_px; ++u) {
            const Vector2d ray = mapper.ray(Vector2d(u, v));
            rays(v, u) = {ray.x(), ray.y(), 1.0};
        }
    }
    return rays;
}

/// Pixels that a sphere may fall on, from the box around it in the camera's frame.
cv::Rect reach(const CameraModel& camera, const Vector3d& centre_m, double radius_m) {
    const cv::Rect all(0, 0, camera.width_px, camera.height_px);
    if (centre_m.z() + radius_m <= 0.0) return {};
    if (centre_m.z() - radius_m <= 0.05 || !has_ideal_lens(camera)) return all;
    const auto range = [&](double at, double f, double c) {
        const double a = std::min((at - radius_m) / (centre_m.z() - radius_m),
                                  (at - radius_m) / (centre_m.z() + radius_m));
        const double b = std::max((at + radius_m) / (centre_m.z() - radius_m),
                                  (at + radius_m) / (centre_m.z() + radius_m));
        constexpr double far = 1e6;
        return std::pair(static_cast<int>(std::max(a * f + c - 1.0, -far)),
                         static_cast<int>(std::min(b * f + c + 2.0, far)));
    };
    const auto [left, right] = range(centre_m.x(), camera.fx_px, camera.cx_px);
    const auto [top, bottom] = range(centre_m.y(), camera.fy_px, camera.cy_px);
    return cv::Rect(left, top, right - left + 1, bottom - top + 1) & all;
}

void draw_floor(cv::Mat1f& depth, const cv::Mat3d& rays, const Isometry3d& T_world_camera) {
    const Vector3d down = -T_world_camera.linear().row(2).transpose();
    const double height_m = T_world_camera.translation().z();
    for (int v = 0; v < depth.rows; ++v) {
        for (int u = 0; u < depth.cols; ++u) {
            const cv::Vec3d& ray = rays(v, u);
            const double falls = down.dot(Vector3d(ray[0], ray[1], ray[2]));
            depth(v, u) = static_cast<float>(falls > 0.0 ? height_m / falls : nothing);
        }
    }
}

void draw_ground(cv::Mat1f& depth, const cv::Mat3d& rays, const World& world,
                 const Isometry3d& T_world_camera) {
    if (world.ground.empty()) return draw_floor(depth, rays, T_world_camera);
    const Ground ground(world);
    for (int v = 0; v < depth.rows; ++v) {
        for (int u = 0; u < depth.cols; ++u) {
            const cv::Vec3d& ray = rays(v, u);
            const Vector3d direction = T_world_camera.linear() * Vector3d(ray[0], ray[1], ray[2]);
            depth(v, u) = static_cast<float>(ground.meet({T_world_camera.translation(), direction}).t);
        }
    }
}

}  // namespace

Isometry3d camera_pose(const CameraMount& mount, const Pose2& T_world_robot, const Isometry3d& T_flat_robot) {
    const double c = std::cos(mount.pitch_rad);
    const double s = std::sin(mount.pitch_rad);
    Eigen::Matrix3d R_robot_level;
    R_robot_level.col(0) = Vector3d(0, -1, 0);
    R_robot_level.col(1) = Vector3d(-s, 0, -c);
    R_robot_level.col(2) = Vector3d(c, 0, -s);
    const Vector3d eye = T_flat_robot * Vector3d(mount.forward_m, mount.left_m, mount.height_m);
    const Vector2d at = transform(T_world_robot, Vector2d(eye.head<2>()));
    Isometry3d pose = Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(T_world_robot.yaw_rad, Vector3d::UnitZ()).toRotationMatrix() *
                    T_flat_robot.linear() * R_robot_level * level_rotation(mount);
    pose.translation() = Vector3d(at.x(), at.y(), eye.z());
    return pose;
}

cv::Mat1f exact_depth(const World& world, const CameraModel& camera, const Isometry3d& T_world_camera,
                      double time_s) {
    const cv::Mat3d rays = rays_of(camera);
    cv::Mat1f depth(camera.height_px, camera.width_px);
    draw_ground(depth, rays, world, T_world_camera);
    for (const Solid& solid : world.solids) {
        if (!solid.visible) continue;
        const Isometry3d T_solid_camera = pose_at(solid, time_s).inverse() * T_world_camera;
        const Vector3d centre = T_solid_camera.inverse().translation();
        const cv::Rect pixels = reach(camera, centre, bounding_radius_m(solid.shape));
        for (int v = pixels.y; v < pixels.y + pixels.height; ++v) {
            for (int u = pixels.x; u < pixels.x + pixels.width; ++u) {
                const cv::Vec3d& ray = rays(v, u);
                const LocalRay local{T_solid_camera.translation(),
                                     T_solid_camera.linear() * Vector3d(ray[0], ray[1], ray[2])};
                const double t =
                    std::visit([&](const auto& shape) { return depth_of(shape, local); }, solid.shape);
                depth(v, u) = std::min(depth(v, u), static_cast<float>(t));
            }
        }
    }
    depth.setTo(0.0F, depth == static_cast<float>(nothing));
    return depth;
}

}  // namespace flownav::sim
