#pragma once
#include <optional>

#include "flownav/core/field.h"
#include "flownav/core/field_status.h"

namespace flownav::pipeline {

/// Why a field cannot be used. `before_s`: time stamp of the field before, if there was one.
FieldFault fault_of(const Field& field, const std::optional<double>& before_s);

/// False for a black, saturated or constant field: nothing can be matched in it. Looks at every 64th pixel.
bool is_picture(const ImageView& image);

}  // namespace flownav::pipeline
