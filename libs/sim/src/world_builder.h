#pragma once

#include <string>

#include "flownav/sim/random.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

/// Puts things into a world, textured in a random grey and numbered per name. Heights are those of the tops;
/// things stand on the floor where nothing else is said.
class WorldBuilder {
  public:
    static constexpr double wall_thickness_m = 0.12;

    WorldBuilder(World& world, Random& random) : world_(world), random_(random) {}

    /// A look of its own.
    Look look(Surface surface, double low_grey, double high_grey);

    void box(const std::string& name, const Pose2& at, const Eigen::Vector2d& size_m, double height_m);
    void pole(const std::string& name, const Eigen::Vector2d& at_m, double radius_m, double height_m,
              double lean_rad = 0.0);
    /// A ball that is sunk into the floor by half its radius.
    void boulder(const std::string& name, const Eigen::Vector2d& at_m, double radius_m);
    /// From a to b; its thickness lies on the right of that way.
    void wall(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);
    /// Seat of 0.45 m with four thin legs and a back; x points to where one sits looking.
    void chair(const Pose2& at);
    /// Top of 1.4 x 0.7 m on four legs; its long side is y.
    void desk(const Pose2& at);

  private:
    std::string numbered(const std::string& name);
    /// Adds one part of a thing at a place in the frame of the thing.
    void part(const std::string& name, const Pose2& thing, const Eigen::Vector3d& centre_m,
              const Shape& shape, const Look& look);

    World& world_;
    Random& random_;
    int count_ = 0;
};

}  // namespace flownav::sim
