#pragma once
#include <memory>

#include "flownav/core/camera_model.h"
#include "flownav/core/image_view.h"

namespace flownav {

/// One camera field: pixels, the time they were taken, and the camera that took them. Copying a field copies
/// no pixel; `owner` keeps them alive.
struct Field {
    double timestamp_s = 0.0;  ///< seconds since the epoch
    ImageView image;
    CameraModel camera;
    std::shared_ptr<const void> owner;
};

}  // namespace flownav
