#include "turned_image.h"

#include <memory>
#include <opencv2/core.hpp>
#include <utility>

namespace flownav::io {
namespace {

constexpr int rows_min = 16;  // a lower image shows no floor

std::string text(int number) {
    return std::to_string(number);
}

/// Rows of an image that are used.
struct UsedRows {
    int first = 0;
    int count = 0;
};

UsedRows used_rows(int height_px, const config::CameraConfig& config) {
    if (!config.masked_rows) return {0, height_px};
    const auto [first, last] = *config.masked_rows;
    UsedRows used = {0, first};
    if (first == 0 && last < height_px - 1) {
        const bool woven = config.interlaced != config::Interlaced::None;
        const int cut = woven ? (last + 2) / 2 * 2 : last + 1;  // keeps the parity of the lines
        used = {cut, height_px - cut};
    } else if (last < height_px - 1) {
        throw config::ConfigError("camera.mask = " + text(first) + ' ' + text(last) +
                                  ": must begin at row 0 or reach the last row, " + text(height_px - 1));
    }
    if (used.count < rows_min) {
        throw config::ConfigError("camera.mask = " + text(first) + ' ' + text(last) + ": leaves " +
                                  text(std::max(used.count, 0)) + " of " + text(height_px) +
                                  " rows; at least " + text(rows_min) + " must be left");
    }
    return used;
}

/// OpenCV's code of a clockwise turn by 90, 180 or 270 degrees.
int rotation_code(int rotate_deg) {
    if (rotate_deg == 90) return cv::ROTATE_90_CLOCKWISE;
    return rotate_deg == 180 ? cv::ROTATE_180 : cv::ROTATE_90_COUNTERCLOCKWISE;
}

cv::Mat turned_pixels(const ImageView& view, const config::CameraConfig& config) {
    constexpr int left_right = 1;
    const cv::Mat recorded(view.height_px, view.width_px, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                           static_cast<std::size_t>(view.stride_bytes));
    cv::Mat mirrored, turned;
    if (config.mirror) cv::flip(recorded, mirrored, left_right);
    const cv::Mat& upright = config.mirror ? mirrored : recorded;
    if (config.rotate_deg == 0) return upright;
    cv::rotate(upright, turned, rotation_code(config.rotate_deg));
    return turned;
}

CameraModel mirrored(CameraModel camera) {
    camera.cx_px = camera.width_px - 1 - camera.cx_px;
    if (camera.lens == &brown_conrady()) camera.distortion[3] = -camera.distortion[3];
    return camera;
}

CameraModel quarter_turned(const CameraModel& camera) {
    CameraModel turned = camera;
    std::swap(turned.width_px, turned.height_px);
    std::swap(turned.fx_px, turned.fy_px);
    turned.cx_px = camera.height_px - 1 - camera.cy_px;
    turned.cy_px = camera.cx_px;
    if (camera.lens == &brown_conrady()) {
        turned.distortion[2] = camera.distortion[3];
        turned.distortion[3] = -camera.distortion[2];
    }
    return turned;
}

}  // namespace

GreyImage turned(const GreyImage& image, const config::CameraConfig& config) {
    GreyImage result = image;
    if (config.mirror || config.rotate_deg != 0) {
        const auto pixels = std::make_shared<const cv::Mat>(turned_pixels(image.view, config));
        result.view = {pixels->data, pixels->cols, pixels->rows, static_cast<std::ptrdiff_t>(pixels->step)};
        result.owner = pixels;
    }
    const UsedRows used = used_rows(result.view.height_px, config);
    result.view.data = result.view.row(used.first);
    result.view.height_px = used.count;
    return result;
}

CameraModel turned(const CameraModel& camera, const config::CameraConfig& config) {
    if (config.rotate_deg != 0 && config.interlaced != config::Interlaced::None) {
        throw config::ConfigError("camera.rotate = " + text(config.rotate_deg) +
                                  ": woven frames cannot be turned; set camera.interlaced = none, or turn "
                                  "the images when they are recorded");
    }
    CameraModel result = config.mirror ? mirrored(camera) : camera;
    for (int angle_deg = 0; angle_deg < config.rotate_deg; angle_deg += 90) result = quarter_turned(result);
    const UsedRows used = used_rows(result.height_px, config);
    result.height_px = used.count;
    result.cy_px -= used.first;
    return result;
}

}  // namespace flownav::io
