#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "flownav/core/pose2.h"

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

enum class Surface : std::uint8_t {
    Plain,      ///< no texture at all
    Carpet,     ///< rich, from half a metre down to a few millimetres
    Tiles,      ///< regular joints, fine faint specks inside
    Lino,       ///< low contrast flecks and streaks
    Patterned,  ///< rich, for objects
    Faint,      ///< wood, metal or plaster: low contrast
};

/// What a surface looks like; the same numbers give the same picture.
struct Look {
    Surface surface = Surface::Patterned;
    double grey = 128.0;     ///< mean grey level, 0..255
    std::uint64_t seed = 0;  ///< of the texture
};

struct TimedPose {
    double time_s = 0.0;
    Eigen::Isometry3d T_world_solid = Eigen::Isometry3d::Identity();
};

/// One thing in the world. Things with a script move: linearly between its poses, at rest before the first
/// and after the last.
struct Solid {
    std::string name;
    Shape shape;
    Eigen::Isometry3d T_world_solid = Eigen::Isometry3d::Identity();
    Look look;
    bool visible = true;  ///< to the camera
    bool solid = true;    ///< to the robot and the lidar
    std::vector<TimedPose> script;
};

/// Pose of a solid, `time_s` after the start of the world.
Eigen::Isometry3d pose_at(const Solid& solid, double time_s);

/// The floor, the plane z = 0, and what stands on it. World frame: z up, metres.
struct World {
    std::string name;
    Look floor{Surface::Carpet, 128.0, 1};
    std::vector<Solid> solids;
    Pose2 start;                          ///< where a robot starts
    std::optional<Eigen::Vector2d> goal;  ///< where it is to go, if the world says so
};

}  // namespace flownav::sim
