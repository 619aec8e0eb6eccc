#pragma once

#include <string>

#include "flownav/sim/world.h"

namespace flownav::sim {

/// Name of a look in a material script: "flownav/Carpet 128 7".
std::string name_of(const Look& look);

/// The look with that name; empty for names that do not begin with "flownav/". Throws std::invalid_argument
/// on one that does and goes wrong.
std::optional<Look> look_named(const std::string& name);

/// Look of a solid without a flownav material: rich texture of middle grey, with a seed made of the name.
Look default_look(const std::string& name_of_solid);

/// The shortest decimal number that is read as the same double.
std::string text_of(double value);

}  // namespace flownav::sim
