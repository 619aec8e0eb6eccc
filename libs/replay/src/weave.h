#pragma once
#include "flownav/core/field.h"

namespace flownav {

/// Every second line of a woven frame as a field of its own (a view), with the camera of those lines.
Field field_of_frame(const Field& frame, bool bottom);

}  // namespace flownav
