#include "flownav/testing/camera.h"

#include <cmath>

#include "flownav/math/units.h"

namespace flownav::testing {

CameraModel standard_camera(int width_px, int height_px) {
    CameraModel camera;
    camera.width_px = width_px;
    camera.height_px = height_px;
    camera.fx_px = camera.fy_px = 0.5 * width_px / std::tan(27.5 * degree_rad);
    camera.cx_px = 0.5 * (width_px - 1);
    camera.cy_px = 0.5 * (height_px - 1);
    camera.mount.height_m = 0.9;
    camera.mount.pitch_rad = 25.0 * degree_rad;
    return camera;
}

}  // namespace flownav::testing
