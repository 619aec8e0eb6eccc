#pragma once

#include <Eigen/Core>
#include <optional>

#include "flownav/core/camera_model.h"
#include "flownav/core/pose2.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

/// A camera on a robot somewhere in the world, at one moment. A camera on a vibrating robot is a camera with
/// another mount.
struct View {
    CameraModel camera;
    Pose2 T_world_robot;
    double time_s = 0.0;  ///< after the start of the world
    /// Height and tilt of the robot on its ground, in the frame of T_world_robot on the plane z = 0.
    Eigen::Isometry3d T_flat_robot = Eigen::Isometry3d::Identity();
};

/// The view with the robot on the pieces of ground of the world, see ride_on_ground().
View on_ground(const World& world, View view);

constexpr int floor_index = -1;

/// Surface that a pixel shows.
struct Sight {
    int solid = floor_index;  ///< index into World::solids, or floor_index for the ground
    int object = 0;           ///< Solid::object; 0 on the ground
    double depth_m = 0.0;     ///< along the optical axis of the LEVEL camera (see RayMapper)
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  ///< in the world frame
};

/// Surface that pixel (u, v) shows; empty when its ray meets neither floor nor solid.
std::optional<Sight> look(const World& world, const View& view, const Eigen::Vector2d& pixel_px);

/// Pixel on which a point of the world frame falls; empty when it is behind the camera. It may lie outside
/// the image, and a nearer surface may hide it.
std::optional<Eigen::Vector2d> project(const View& view, const Eigen::Vector3d& point_m);

/// Exact displacement, from one view to the next, of the point that a pixel shows.
struct FlowTruth {
    Eigen::Vector2d flow_px = Eigen::Vector2d::Zero();
    Sight sight;            ///< in `from`
    bool inside = false;    ///< still within the image in `to`
    bool occluded = false;  ///< hidden by another surface in `to`
};

/// Exact flow of a pixel of `from`; empty when it shows neither floor nor solid, or the point is behind `to`.
std::optional<FlowTruth> exact_flow(const World& world, const View& from, const View& to,
                                    const Eigen::Vector2d& pixel_px);

}  // namespace flownav::sim
