#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/math/footprint.h"

namespace flownav::sim {

// Shapes are centred at the origin of their solid, as in SDF; a cylinder stands along z.
struct Box {
    Eigen::Vector3d size_m = Eigen::Vector3d::Ones();
};
struct Cylinder {
    double radius_m = 0.5;
    double length_m = 1.0;
};
struct Sphere {
    double radius_m = 0.5;
};
using Shape = std::variant<Box, Cylinder, Sphere>;

/// Texture of a surface. The GL renderer draws Tiles as Stoneware, Lino as Marbled and Wall as Faint.
enum class Surface : std::uint8_t {
    Plain = 0,      ///< no texture
    Carpet = 1,     ///< rich, from half a metre down to a few millimetres
    Tiles = 2,      ///< regular dark joints, hardly any texture inside
    Lino = 3,       ///< low contrast
    Wall = 4,       ///< painted rough plaster, low contrast
    Patterned = 5,  ///< rich, for objects
    Faint = 6,      ///< wood, metal or plaster: low contrast
    Stoneware = 7,  ///< tiles with fine faint specks inside
    Marbled = 8,    ///< linoleum with faint flecks and streaks
    Lamp = 9,       ///< no texture; floors that shine show its reflection
};

/// Texture, mean grey and seed of a surface; the same numbers give the same picture.
struct Look {
    Surface surface = Surface::Patterned;
    double grey = 128.0;     ///< mean grey level, 0..255; contrasts are proportional to it
    std::uint64_t seed = 0;  ///< of the texture
};

struct TimedPose {
    double time_s = 0.0;
    Eigen::Isometry3d T_world_solid = Eigen::Isometry3d::Identity();
};

/// Class of an object, for evaluation.
enum class ThingKind : std::uint8_t { Wall, Box, LowBox, Pole, Drum, Chair, Rail, Mover };

const char* to_string(ThingKind kind);

/// One rigid part of the world. A solid with a script moves: linearly between its poses, at rest before the
/// first and after the last.
struct Solid {
    std::string name;
    Shape shape;
    Eigen::Isometry3d T_world_solid = Eigen::Isometry3d::Identity();
    Look look;
    bool visible = true;  ///< to the camera
    bool solid = true;    ///< to the robot and the lidar
    std::vector<TimedPose> script;
    ThingKind kind = ThingKind::Box;  ///< of the object that it is a part of
    int object = 0;                   ///< number of that object: its solids share it
};

/// Pose of a solid, `time_s` after the start of the world.
Eigen::Isometry3d pose_at(const Solid& solid, double time_s);

/// Bumps and hollows of the floor, a quarter to six tenths of a metre long, in all directions.
struct FloorWaves {
    double highest_m = 0.0;  ///< above and below z = 0; 0: a plane
    std::uint64_t seed = 0;
};

/// A flat piece of ground that carries the robot: a tread of a stair, the bottom of a hole, a kerb, a ramp.
/// Below z = 0 it opens a hole in the floor. Its sides are vertical walls down to the ground beside it.
struct GroundPiece {
    std::string name;
    /// Middle of the rectangle, with z along its upward normal, which leans by at most 20 degrees.
    Eigen::Isometry3d T_world_ground = Eigen::Isometry3d::Identity();
    Eigen::Vector2d size_m = Eigen::Vector2d::Ones();  ///< along x and y of its frame
    Look look;                                         ///< of the top; its sides are darker
};

/// Outline and height of a body that throws a shadow.
struct ShadowBody {
    Polygon footprint_m;  ///< in the robot frame
    double height_m = 1.0;
};

/// A far light that throws shadows onto the floor z = 0. Shadows of several solids darken one after another.
struct ShadowLight {
    Eigen::Vector3d towards{-0.3, 0.2, 1.0};  ///< direction from the floor to the light, z > 0
    double loss = 0.5;                        ///< share of the light that a shadow takes, 0..1
    double soft_m = 0.02;                     ///< width of a shadow's edge, >= 0
    std::optional<ShadowBody> robot;          ///< the robot throws a shadow, too
};

/// The ground and the solids on it. The ground is the highest of the pieces at a place, and where there is
/// none the floor: the plane z = 0 with its waves. World frame: z up, metres.
struct World {
    std::string name;
    Look floor{Surface::Carpet, 128.0, 1};
    std::vector<Solid> solids;
    Pose2 start;                          ///< where a robot starts
    std::optional<Eigen::Vector2d> goal;  ///< where it is to go, if the world says so
    FloorWaves waves = {};                ///< drawn by the ray caster only
    double sky_grey = 215.0;              ///< grey level where a ray meets neither floor nor solid
    double shading = 0.0;  ///< share of the light that depends on a face's direction, 0..1; ray caster only
    std::vector<GroundPiece> ground = {};
    std::optional<ShadowLight> shadow_light = {};
};

/// Seconds since the epoch at which every simulated world starts.
constexpr double sim_start_s = 1767225600.0;

}  // namespace flownav::sim
