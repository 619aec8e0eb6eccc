#pragma once

#include <cstdint>

#include "flownav/core/camera_model.h"

namespace flownav::sim {

enum class Parity : std::uint8_t { Top, Bottom };

/// The camera of one field of an interlaced frame: row v of the top field is row 2v of the frame, row v of
/// the bottom field is row 2v + 1.
CameraModel field_camera(const CameraModel& frame_camera, Parity parity);

}  // namespace flownav::sim
