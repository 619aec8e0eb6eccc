#pragma once
#include <memory>

#include "flownav/core/camera_model.h"
#include "flownav/core/image_view.h"

namespace flownav {

/// One camera field: pixels, time and camera. Copying a field copies no pixels; `owner` keeps them alive.
struct Field {
    double timestamp_s = 0.0;  ///< seconds since the epoch
    ImageView image;
    CameraModel camera;
    std::shared_ptr<const void> owner;
};

}  // namespace flownav
