#pragma once
#include <cstdint>

#include "flownav/core/camera_model.h"

namespace flownav::testing {

/// 0.9 m high, looking 25 degrees down, 55 degrees wide, square pixels, principal point in the middle.
CameraModel standard_camera(int width_px = 640, int height_px = 480);

enum class Parity : std::uint8_t { Top, Bottom };

/// The camera of one field of an interlaced frame: row v of the top field is row 2v of the frame, row v of
/// the bottom field is row 2v + 1.
CameraModel field_camera(const CameraModel& frame_camera, Parity parity);

}  // namespace flownav::testing
