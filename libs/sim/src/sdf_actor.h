#pragma once

#include <sdf/Element.hh>

#include "flownav/sim/sdf_world.h"

namespace flownav::sim {

/// Adds an actor of an SDF world: something on a scripted path. Throws std::invalid_argument.
void read_actor(const sdf::ElementPtr& actor, LoadedWorld& loaded);

}  // namespace flownav::sim
