#pragma once
#include <vector>

#include "flownav/testing/random.h"
#include "flownav/testing/world.h"

namespace flownav::testing {

/// One thing, standing at the origin; all its primitives carry the same object number.
using Thing = std::vector<Primitive>;

Thing make_chair(Random& random);
Thing make_drum(Random& random);
Thing make_pole(Random& random);
Thing make_low_box(Random& random);
Thing make_box(Random& random);

/// A railing along x: three posts and two bars.
Thing make_rail(double length_m, Random& random);

/// A wall with a dark skirting board, between two points; the room is to its left.
Thing make_wall(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);

/// The thing turned by yaw about the origin and then moved.
Thing placed(Thing thing, const Eigen::Vector2d& at_m, double yaw_rad, int object, Random& random);

}  // namespace flownav::testing
