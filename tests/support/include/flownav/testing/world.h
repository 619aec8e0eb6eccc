#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "flownav/testing/texture.h"

namespace flownav::testing {

enum class Shape : std::uint8_t { Box = 0, Cylinder = 1 };

/// What a primitive is part of.
enum class ThingKind : std::uint8_t { Wall, Box, LowBox, Pole, Drum, Chair, Rail, Mover };

const char* to_string(ThingKind kind);

/// An upright box (turned by yaw) or an upright cylinder, in the world frame: x, y on the ground, z up,
/// metres.
struct Primitive {
    Shape shape = Shape::Box;
    ThingKind kind = ThingKind::Box;
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    double z_low_m = 0.0;
    double z_high_m = 1.0;
    double half_x_m = 0.5;  ///< of a cylinder: its radius
    double half_y_m = 0.5;  ///< of a cylinder: unused, 0
    double yaw_rad = 0.0;
    Texture texture;
    int object = 0;  ///< primitives of one thing share a number; walls have wall_object
    Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();
};

constexpr int wall_object = 100;

/// Bumps and hollows of the floor, a quarter to six tenths of a metre long, in all directions.
struct FloorWaves {
    double highest_m = 0.0;  ///< above and below z = 0; 0: a plane
    std::uint64_t seed = 0;
};

/// The ground, the plane z = 0 with its waves, and what stands on it, at time 0.
struct World {
    Texture ground{Surface::Carpet, 1.0, 1};
    std::vector<Primitive> primitives;
    FloorWaves waves = {};
};

/// The world `time_s` later: everything that has a velocity has moved, with its texture.
World at_time(const World& world, double time_s);

/// Height of the ground at a point.
double ground_height_m(const World& world, const Eigen::Vector2d& at_m);

/// Horizontal distance of a point to the outline of a primitive; 0 inside.
double distance_m(const Primitive& primitive, const Eigen::Vector2d& point_m);

}  // namespace flownav::testing
