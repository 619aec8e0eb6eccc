#pragma once
#include "flownav/core/image_view.h"

namespace flownav::pipeline {

/// False for a black, saturated or constant field: nothing can be matched in it. Looks at every 64th pixel.
bool is_picture(const ImageView& image);

}  // namespace flownav::pipeline
