#pragma once

#include <ignition/math/Pose3.hh>
#include <optional>
#include <string>
#include <vector>

#include "flownav/sim/world.h"

namespace flownav::sim {

Eigen::Isometry3d to_isometry(const ignition::math::Pose3d& pose);

/// A shape whose measures are > 0 and finite, or std::invalid_argument.
Shape checked(const Shape& shape);

/// The solids of one model. A collision and a visual of the same shape in the same place are one solid.
class Parts {
  public:
    void add_solid(const Shape& shape, const Eigen::Isometry3d& T, const std::string& name);
    void add_visible(const Shape& shape, const Eigen::Isometry3d& T, const std::optional<Look>& look,
                     const std::string& name);

    void add(Solid solid) { solids_.push_back(std::move(solid)); }

    std::vector<Solid> take() { return std::move(solids_); }

  private:
    std::vector<Solid> solids_;
};

/// Adds the parts of a model to a world. A model of one part lends it its name.
void add_parts(World& world, const std::string& model, Parts parts);

}  // namespace flownav::sim
