#pragma once
#include <string>

#include "view_model.h"

namespace flownav::view {

/// Returns the view as one line of JSON: the field and its step, the block under the mouse with its numbers
/// and its SAD minimum, the parameters, and how much of the drive has been read.
std::string state_json(const ViewModel& model);

}  // namespace flownav::view
