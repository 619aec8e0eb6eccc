#include "flownav/sim/field_camera.h"

namespace flownav::sim {

CameraModel field_camera(const CameraModel& frame_camera, Parity parity) {
    const int first_row = parity == Parity::Top ? 0 : 1;
    CameraModel camera = frame_camera;
    camera.height_px = (frame_camera.height_px + 1 - first_row) / 2;
    camera.fy_px = 0.5 * frame_camera.fy_px;
    camera.cy_px = 0.5 * (frame_camera.cy_px - first_row);
    return camera;
}

}  // namespace flownav::sim
