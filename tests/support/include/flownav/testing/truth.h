#pragma once
#include <Eigen/Core>
#include <optional>

#include "flownav/core/camera_model.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/pose2.h"
#include "flownav/testing/world.h"

namespace flownav::testing {

/// A camera on a robot somewhere in the world, at one moment. A camera on a vibrating robot or an uneven
/// floor is a camera with another mount.
struct View {
    CameraModel camera;
    Pose2 T_world_robot;
    double time_s = 0.0;
};

constexpr int ground_primitive = -1;

/// What a pixel shows.
struct Sight {
    int primitive = ground_primitive;  ///< index into World::primitives, or the ground
    int object = 0;                    ///< Primitive::object; 0 on the ground
    double depth_m = 0.0;              ///< along the optical axis of the LEVEL camera (see RayMapper)
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  ///< in the world frame
};

/// What pixel (u, v) shows; nothing when its ray meets nothing.
std::optional<Sight> look(const World& world, const View& view, const Eigen::Vector2d& pixel_px);

/// Pixel on which a point of the world frame falls; nothing when it is behind the camera. It may lie outside
/// the image, and something nearer may hide it.
std::optional<Eigen::Vector2d> project(const View& view, const Eigen::Vector3d& point_m);

/// Exact displacement of what a pixel of `from` shows to where it is in `to`.
struct FlowTruth {
    Eigen::Vector2d flow_px = Eigen::Vector2d::Zero();
    Sight sight;            ///< in `from`
    bool inside = false;    ///< still within the image in `to`
    bool occluded = false;  ///< something else hides it in `to`
};

std::optional<FlowTruth> exact_flow(const World& world, const View& from, const View& to,
                                    const Eigen::Vector2d& pixel_px);

/// Exact motion between two poses, as the sensor reports it: turn, and the chord along half the turn.
EgoMotion exact_motion(const Pose2& from, const Pose2& to);

/// The same with the turn about the camera's x axis, from the pitch of the two mounts.
EgoMotion exact_motion(const View& from, const View& to);

}  // namespace flownav::testing
