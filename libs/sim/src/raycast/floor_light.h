#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "flownav/sim/world.h"

namespace flownav::sim {

/// Surfaces up to this height count as the floor for shadows and reflections: tape, paper, mats.
constexpr double mark_height_m = 0.0012;

/// Share of light that vertical sides of the ground show of their look.
constexpr double wall_shade = 0.75;

/// Look of the sides of a piece of ground.
Look wall_look(const GroundPiece& piece);

/// A shadow on the floor: a convex outline, as normals that point outward and their distances from the
/// origin.
struct FloorShadow {
    std::vector<Eigen::Vector3d> sides;  ///< normal x, normal y, distance
    Eigen::AlignedBox2d extent_m;        ///< with the soft edge
    double loss = 0.5;
    double soft_m = 0.02;
};

/// Reflection of a lamp in the floor: a bell whose axes are those of the line of sight.
struct FloorSpot {
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    Eigen::Matrix2d to_sigmas = Eigen::Matrix2d::Identity();  ///< from metres off the centre to sigmas
    double reach_m = 0.0;                                     ///< 3.5 sigmas of the longer axis
    double grey = 0.0;                                        ///< added in the middle
};

/// Shadows on the floor and reflections in it, for one moment and one eye.
class FloorLight {
  public:
    FloorLight(const World& world, const Pose2& T_world_robot, double time_s, const Eigen::Vector3d& eye_m);

    bool empty() const { return shadows_.empty() && spots_.empty(); }

    /// Grey of the floor at a place in this light; a pixel covers a parallelogram of the two steps there.
    double lit(double grey, const Eigen::Vector2d& at_m, const Eigen::Vector2d& right_m,
               const Eigen::Vector2d& down_m) const;

    const std::vector<FloorShadow>& shadows() const { return shadows_; }
    const std::vector<FloorSpot>& spots() const { return spots_; }

  private:
    void add_shadows(const World& world, const Pose2& T_world_robot, double time_s);
    void add_shadow(const ShadowLight& light, const std::vector<Eigen::Vector3d>& points_m);
    void add_spots(const World& world, double time_s, const Eigen::Vector3d& eye_m);

    std::vector<FloorShadow> shadows_;
    std::vector<FloorSpot> spots_;
};

}  // namespace flownav::sim
