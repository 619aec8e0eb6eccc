#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <variant>

#include "flownav/math/footprint.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

struct Disc {
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    double radius_m = 0.0;
};
/// Polygons are convex here.
using PlanShape = std::variant<Disc, Polygon>;

/// What a shape covers, seen from above, with its part between two heights (world frame, low_m <= high_m;
/// equal heights give a section). Empty when it has no part there. Exact for upright cylinders, spheres and
/// boxes in any attitude; a tilted cylinder counts as the prism of 32 sides around it, which is up to 0.5 %
/// of its radius wider.
std::optional<PlanShape> plan_view(const Shape& shape, const Eigen::Isometry3d& T_world_shape, double low_m,
                                   double high_m);

/// Radius of the sphere around the shape's origin that holds all of it.
double bounding_radius_m(const Shape& shape);

}  // namespace flownav::sim
