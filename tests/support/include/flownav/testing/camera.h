#pragma once
#include "flownav/core/camera_model.h"
#include "flownav/sim/field_camera.h"

namespace flownav::testing {

using sim::field_camera;
using sim::Parity;

/// 0.9 m high, looking 25 degrees down, 55 degrees wide, square pixels, principal point in the middle.
CameraModel standard_camera(int width_px = 640, int height_px = 480);

}  // namespace flownav::testing
