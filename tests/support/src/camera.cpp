#include "flownav/testing/camera.h"

#include <cmath>

namespace flownav::testing {

CameraModel standard_camera(int width_px, int height_px) {
    constexpr double degree = M_PI / 180.0;
    CameraModel camera;
    camera.width_px = width_px;
    camera.height_px = height_px;
    camera.fx_px = camera.fy_px = 0.5 * width_px / std::tan(27.5 * degree);
    camera.cx_px = 0.5 * (width_px - 1);
    camera.cy_px = 0.5 * (height_px - 1);
    camera.mount.height_m = 0.9;
    camera.mount.pitch_rad = 25.0 * degree;
    return camera;
}

CameraModel field_camera(const CameraModel& frame_camera, Parity parity) {
    const int first_row = parity == Parity::Top ? 0 : 1;
    CameraModel camera = frame_camera;
    camera.height_px = (frame_camera.height_px + 1 - first_row) / 2;
    camera.fy_px = 0.5 * frame_camera.fy_px;
    camera.cy_px = 0.5 * (frame_camera.cy_px - first_row);
    return camera;
}

}  // namespace flownav::testing
