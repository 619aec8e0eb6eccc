#include "field_quality.h"

#include <cmath>
#include <cstdint>

namespace flownav::pipeline {
namespace {

constexpr int step_px = 8;
constexpr double variance_min = 0.5;  // grey levels squared; a plain floor under noise has more
constexpr double saturated_share_max = 0.9;
constexpr int black = 2;
constexpr int white = 253;

/// True when the camera describes the image, and every row of it can be read.
bool has_size_of(const ImageView& image, const CameraModel& camera) {
    return image.width_px == camera.width_px && image.height_px == camera.height_px &&
           std::abs(image.stride_bytes) >= image.width_px;
}

bool is_usable(const CameraModel& c) {
    double sum = c.fx_px + c.fy_px + c.cx_px + c.cy_px + c.mount.height_m + c.mount.pitch_rad +
                 c.mount.roll_rad + c.mount.yaw_rad + c.mount.forward_m + c.mount.left_m;
    for (const double k : c.distortion) sum += k;
    return std::isfinite(sum) && c.fx_px > 0.0 && c.fy_px > 0.0 && c.mount.height_m > 0.0;
}

}  // namespace

FieldFault fault_of(const Field& field, const std::optional<double>& before_s) {
    if (!std::isfinite(field.timestamp_s) || (before_s && field.timestamp_s <= *before_s))
        return FieldFault::TimeNotRising;
    if (field.image.empty()) return FieldFault::NoPicture;
    if (!has_size_of(field.image, field.camera)) return FieldFault::WrongSize;
    if (!is_usable(field.camera)) return FieldFault::BadCamera;
    return is_picture(field.image) ? FieldFault::None : FieldFault::NoPicture;
}

bool is_picture(const ImageView& image) {
    if (image.empty()) return false;
    std::int64_t counted = 0, greys = 0, squares = 0, saturated = 0;
    for (int v = 0; v < image.height_px; v += step_px) {
        const std::uint8_t* row = image.row(v);
        for (int u = 0; u < image.width_px; u += step_px) {
            const int grey = row[u];
            ++counted;
            greys += grey;
            squares += grey * grey;
            saturated += static_cast<int>(grey <= black) | static_cast<int>(grey >= white);
        }
    }
    const auto n = static_cast<double>(counted);
    const double mean = static_cast<double>(greys) / n;
    return static_cast<double>(squares) / n - mean * mean >= variance_min &&
           static_cast<double>(saturated) <= saturated_share_max * n;
}

}  // namespace flownav::pipeline
