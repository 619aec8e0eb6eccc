#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "flownav/sim/truth.h"
#include "ground.h"

namespace flownav::sim {

enum Face : int { Side = 0, SideNegX = 1, SidePosX = 2, SideNegY = 3, SidePosY = 4, Top = 5, Bottom = 6 };

constexpr int no_surface = -2;

struct Hit {
    int solid = no_surface;  ///< index, floor_index or no_surface
    int face = Top;
    double t = std::numeric_limits<double>::infinity();
    int piece = bare_floor;  ///< of the ground, index into World::ground, when solid is floor_index
    bool inner = false;      ///< the wall of a piece that faces its inside
};

/// A solid at one moment.
struct PlacedSolid {
    Shape shape;
    Eigen::Matrix3d R_world_solid;
    Eigen::Vector3d centre_m;
    double rest_z_m = 0.0;  ///< height at which the solid rests: textures of sides begin at z = 0 there
    bool visible = true;

    Eigen::Vector3d to_local(const Eigen::Vector3d& direction) const {
        return R_world_solid.transpose() * direction;
    }
    Eigen::Vector3d local_point(const Eigen::Vector3d& point_m) const {
        return R_world_solid.transpose() * (point_m - centre_m);
    }
};

/// All solids of the world, in its order.
std::vector<PlacedSolid> solids_at(const World& world, double time_s);

/// Indices of the visible solids.
std::vector<int> visible_of(const std::vector<PlacedSolid>& solids);

/// First surface that the ray meets: the ground, or one of the named solids.
Hit cast(const std::vector<PlacedSolid>& solids, const Ground& ground, const std::vector<int>& candidates,
         const Ray& ray);

/// Plane that touches the surface at a hit, and the place of the point on its texture: u and v, metres.
struct Tangent {
    Eigen::Vector3d normal;
    Eigen::Vector3d u_axis;
    Eigen::Vector3d v_axis;
    Eigen::Vector2d uv_m;
};

Tangent tangent_at(const std::vector<PlacedSolid>& solids, const std::vector<GroundPiece>& ground,
                   const Hit& hit, const Eigen::Vector3d& point_m);

/// Rays of a view: the camera's position, and the direction of a level ray (x, y, 1).
struct RayFrame {
    explicit RayFrame(const View& view);

    Eigen::Vector3d direction(const Eigen::Vector2d& level_ray) const {
        return forward + level_ray.x() * right + level_ray.y() * down;
    }

    Eigen::Vector3d origin_m, right, down, forward;
};

}  // namespace flownav::sim
