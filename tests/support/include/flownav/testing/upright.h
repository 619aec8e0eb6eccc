#pragma once
#include <Eigen/Core>

#include "flownav/sim/world.h"

namespace flownav::testing {

using sim::Look;
using sim::Solid;
using sim::Surface;
using sim::ThingKind;
using sim::World;

enum class UprightShape : std::uint8_t { Box = 0, Cylinder = 1 };

/// An upright box (turned by yaw) or an upright cylinder, in the world frame: x, y on the ground, z up,
/// metres.
struct Upright {
    UprightShape shape = UprightShape::Box;
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    double z_low_m = 0.0;
    double z_high_m = 1.0;
    double half_x_m = 0.5;  ///< of a cylinder: its radius
    double half_y_m = 0.5;  ///< of a cylinder: unused, 0
    double yaw_rad = 0.0;
};

constexpr int wall_object = 100;  ///< object number of all walls

/// A resting solid of that shape, object 0.
Solid solid_of(const Upright& upright, const Look& look);

/// Shape of a solid where it rests. Throws std::invalid_argument for spheres and tilted solids.
Upright upright_of(const Solid& solid);

/// Lets a solid move from where it rests at time 0, with its texture, until `until_s`.
void set_velocity(Solid& solid, const Eigen::Vector2d& velocity_mps, double until_s);

/// The world `time_s` later: every solid rests where its script has brought it.
World at_time(const World& world, double time_s);

/// Horizontal distance of a point to the outline of an upright solid where it rests; 0 inside.
double distance_m(const Solid& solid, const Eigen::Vector2d& point_m);

}  // namespace flownav::testing
