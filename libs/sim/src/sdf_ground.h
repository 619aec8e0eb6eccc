#pragma once

#include <optional>
#include <sdf/Element.hh>
#include <string>

#include "flownav/sim/world.h"
#include "sdf_parts.h"

namespace flownav::sim {

/// Name of the element of a world that holds its shadow light: towards x y z, loss, soft_m.
constexpr const char* shadows_element = "flownav:shadows";

/// True for models whose boxes are ground: their name begins with "ground".
bool is_ground(const std::string& model_name);

/// True when a robot can stand on a surface whose normal is the z axis: it leans by at most 20 degrees.
bool is_walkable(const Eigen::Isometry3d& T_world_surface);

/// "model" of "model/link/part", the name of a part.
std::string model_of(const std::string& part_name);

/// Carpet of middle grey, with a seed made of the name.
Look default_ground_look(const std::string& name);

/// Adds a piece of ground. A piece in the same place, its collision or visual, becomes the same piece; the
/// visual gives its look and its name is kept.
void add_ground(World& world, const GroundPiece& piece, bool is_visual);

/// Moves the boxes that a robot can stand on to the ground of the world; returns the other parts.
Parts take_ground(World& world, Parts& parts);

/// The light of an SDF world; empty when it has none. Throws std::invalid_argument with the text that is
/// wrong.
std::optional<ShadowLight> shadow_light_of(const sdf::ElementPtr& world);

}  // namespace flownav::sim
