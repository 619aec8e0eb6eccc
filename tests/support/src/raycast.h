#pragma once
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "floor.h"
#include "flownav/testing/truth.h"

namespace flownav::testing {

enum Face : int { Side = 0, SideNegX = 1, SidePosX = 2, SideNegY = 3, SidePosY = 4, Top = 5, Bottom = 6 };

constexpr int nothing = -2;

struct Hit {
    int primitive = nothing;  ///< index, ground_primitive or nothing
    int face = Top;
    double t = std::numeric_limits<double>::infinity();
};

/// A primitive with its turn worked out.
struct Solid {
    Primitive shape;
    double cos_yaw = 1.0;
    double sin_yaw = 0.0;

    Eigen::Vector3d to_local(const Eigen::Vector3d& direction) const {
        return {cos_yaw * direction.x() + sin_yaw * direction.y(),
                -sin_yaw * direction.x() + cos_yaw * direction.y(), direction.z()};
    }
    Eigen::Vector3d to_world(const Eigen::Vector3d& direction) const {
        return {cos_yaw * direction.x() - sin_yaw * direction.y(),
                sin_yaw * direction.x() + cos_yaw * direction.y(), direction.z()};
    }
    Eigen::Vector3d local_point(const Eigen::Vector3d& point_m) const {
        return to_local({point_m.x() - shape.centre_m.x(), point_m.y() - shape.centre_m.y(), point_m.z()});
    }
};

std::vector<Solid> solids_of(const World& world, double time_s);

/// First thing the ray meets: the ground, or one of the named solids.
Hit cast(const std::vector<Solid>& solids, const Floor& floor, const std::vector<int>& candidates,
         const Ray& ray);

/// Plane that touches what was hit, and how its texture lies: u and v of a point, metres.
struct Tangent {
    Eigen::Vector3d normal;
    Eigen::Vector3d u_axis;
    Eigen::Vector3d v_axis;
    Eigen::Vector2d uv_m;
};

Tangent tangent_at(const std::vector<Solid>& solids, const Hit& hit, const Eigen::Vector3d& point_m);

/// Rays of a view: where the camera is, and the direction of a level ray (x, y, 1).
struct RayFrame {
    explicit RayFrame(const View& view);

    Eigen::Vector3d direction(const Eigen::Vector2d& level_ray) const {
        return forward + level_ray.x() * right + level_ray.y() * down;
    }

    Eigen::Vector3d origin_m, right, down, forward;
};

}  // namespace flownav::testing
