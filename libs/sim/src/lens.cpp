#include "lens.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace flownav::sim {
namespace {

constexpr int border_px = 2;  // for the interpolation
constexpr double growth_max = 3.0;

/// Undistorted rays of all pixels of the supersampled image, scaled to pixels of the pinhole picture.
void fill_tables(Lens& lens, const CameraModel& camera, int supersampling) {
    CameraModel level = camera;
    level.mount = {};
    const RayMapper mapper(level);
    const int width = camera.width_px * supersampling;
    const int height = camera.height_px * supersampling;
    lens.map_x.create(height, width);
    lens.map_y.create(height, width);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Eigen::Vector2d ray =
                mapper.ray({(x + 0.5) / supersampling - 0.5, (y + 0.5) / supersampling - 0.5});
            lens.map_x(y, x) = static_cast<float>(ray.x() * lens.pinhole.fx_px);
            lens.map_y(y, x) = static_cast<float>(ray.y() * lens.pinhole.fy_px);
        }
    }
}

/// Moves a table so that it begins at the border of the picture; gives the size, and the moved origin.
int settle(cv::Mat1f& table, int size_px, double& centre_px) {
    double low = 0.0;
    double high = 0.0;
    cv::minMaxLoc(table, &low, &high);
    if (!std::isfinite(low) || !std::isfinite(high) || high - low > growth_max * size_px)
        throw std::invalid_argument("camera.distortion: bends rays too far for a simulated camera");
    centre_px = std::ceil(border_px - low) + 0.5;
    table.convertTo(table, CV_32F, 1.0, centre_px - 0.5);
    return static_cast<int>(std::ceil(high + centre_px)) + border_px;
}

}  // namespace

Lens make_lens(const CameraModel& camera, int supersampling) {
    Lens lens;
    const double s = supersampling;
    lens.pinhole = {{camera.width_px * supersampling, camera.height_px * supersampling},
                    camera.fx_px * s,
                    camera.fy_px * s,
                    (camera.cx_px + 0.5) * s,
                    (camera.cy_px + 0.5) * s};
    if (has_ideal_lens(camera)) return lens;
    fill_tables(lens, camera, supersampling);
    cv::Size& size = lens.pinhole.size_px;
    size.width = settle(lens.map_x, size.width, lens.pinhole.cx_px);
    size.height = settle(lens.map_y, size.height, lens.pinhole.cy_px);
    return lens;
}

}  // namespace flownav::sim
