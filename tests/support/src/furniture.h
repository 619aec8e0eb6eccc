#pragma once
#include <vector>

#include "flownav/sim/random.h"
#include "flownav/testing/upright.h"

namespace flownav::testing {

/// A piece of furniture: `shade` is the factor on the usual grey of its surface.
struct Part {
    Upright shape;
    Surface surface = Surface::Patterned;
    double shade = 1.0;
    ThingKind kind = ThingKind::Box;
};

/// One object, standing at the origin.
using Thing = std::vector<Part>;

Thing make_chair(sim::HashRandom& random);
Thing make_drum(sim::HashRandom& random);
Thing make_pole(sim::HashRandom& random);
Thing make_low_box(sim::HashRandom& random);
Thing make_box(sim::HashRandom& random);

/// A railing along x: three posts and two bars.
Thing make_rail(double length_m, sim::HashRandom& random);

/// A wall with a dark skirting board, between two points; the room is to its left.
Thing make_wall(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);

/// The solids of an object that was turned by yaw about the origin and then moved. All have its number, each
/// its own texture.
std::vector<Solid> placed(Thing thing, const Eigen::Vector2d& at_m, double yaw_rad, int object,
                          sim::HashRandom& random);

}  // namespace flownav::testing
