#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "flownav/core/robot_model.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

/// Highest step of the ground that a wheel climbs, and deepest that it drops without a fall, metres. A
/// threshold of 2 cm is driven over, a kerb of 5 cm is not.
constexpr double step_max_m = 0.03;

/// Height of the ground at a point of the world frame, metres.
double ground_height_m(const World& world, const Eigen::Vector2d& at_m);

/// Sum of the steps of the ground on the straight way between two points: > 0 when they lead upward. Slopes
/// do not count.
double ground_steps_m(const World& world, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);

/// A vertical wall where the ground has a step, as seen from its lower side.
struct GroundWall {
    int piece = 0;  ///< index into World::ground of the piece that it belongs to
    Eigen::Vector3d left_m = Eigen::Vector3d::Zero();   ///< left end of its foot
    Eigen::Vector3d right_m = Eigen::Vector3d::Zero();  ///< right end of its foot
    double left_rise_m = 0.0;                           ///< height of the wall there
    double right_rise_m = 0.0;
};

/// All walls between the pieces of ground and the floor; a wall does not cross itself or end inside a piece.
std::vector<GroundWall> ground_walls(const World& world);

/// Pose of a robot on its ground, in the frame that its Pose2 has on the plane z = 0: height and tilt. It
/// stands on four wheels of 6 cm radius at +-0.15 m; a wheel over a step beyond `step_max_m` is held at the
/// robot's level. The identity on the bare floor.
Eigen::Isometry3d ride_on_ground(const World& world, const Pose2& T_world_robot);

/// A part of the outline that hangs over lower ground.
struct Overhang {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();  ///< in the world frame
    double depth_m = 0.0;                            ///< of the ground there below the robot's own ground
};

/// The deepest point of the ground below a robot's outline, its corners and points every 2 cm between them,
/// when it lies more than `step_max_m` below the ground of the axis, slopes not counted: the robot has
/// fallen.
std::optional<Overhang> overhang(const World& world, const Polygon& footprint_m, const Pose2& T_world_robot);

}  // namespace flownav::sim
