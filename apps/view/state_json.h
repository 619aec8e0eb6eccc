#pragma once
#include <string>

#include "view_model.h"

namespace flownav::view {

/// What is shown, in one line of JSON: the field and its step, the block under the mouse with its numbers and
/// its SAD minimum, the parameters, and how much of the drive is known.
std::string state_json(const ViewModel& model);

}  // namespace flownav::view
