#include "flownav/obstacles/level_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flownav::obstacles {
namespace {

bool is_plain(const CameraModel& camera) {
    return has_ideal_lens(camera) && camera.mount.roll_rad == 0.0 && camera.mount.yaw_rad == 0.0;
}

/// The middle of a pixel of half resolution lies between four pixels of the image.
LevelCamera half_camera(const CameraModel& c) {
    return {c.fx_px / 2,
            c.fy_px / 2,
            (c.cx_px - 0.5) / 2,
            (c.cy_px - 0.5) / 2,
            std::cos(c.mount.pitch_rad),
            std::sin(c.mount.pitch_rad),
            c.mount.height_m};
}

/// Means of 2x2 pixels.
void halve(const ImageView& image, int width, int height, float* out) {
    for (int v = 0; v < height; ++v, out += width) {
        const std::uint8_t* const upper = image.row(2 * v);
        const std::uint8_t* const lower = image.row(2 * v + 1);
        for (int u = 0; u < width; ++u) {
            const int sum = upper[2 * u] + upper[2 * u + 1] + lower[2 * u] + lower[2 * u + 1];
            out[u] = 0.25F * static_cast<float>(sum);
        }
    }
}

}  // namespace

double corner_radius_px(const LevelImage& image) {
    return 0.5 * std::hypot(image.width, image.height);
}

void take_out_vignetting(LevelImage& image, double vignetting) {
    if (image.vignetting == vignetting) return;
    const double radius2 = corner_radius_px(image) * corner_radius_px(image);
    const auto before = static_cast<float>(image.vignetting / radius2);
    const auto after = static_cast<float>(vignetting / radius2);
    const float middle_u = 0.5F * static_cast<float>(image.width - 1);
    const float middle_v = 0.5F * static_cast<float>(image.height - 1);
    for (int v = 0; v < image.height; ++v) {
        float* const row = image.row(v);
        const float dy2 = (static_cast<float>(v) - middle_v) * (static_cast<float>(v) - middle_v);
        for (int u = 0; u < image.width; ++u) {
            const float dx = static_cast<float>(u) - middle_u;
            const float r2 = dx * dx + dy2;
            row[u] *= (1.0F - before * r2) / (1.0F - after * r2);
        }
    }
    image.vignetting = vignetting;
}

LevelMapping::LevelMapping(const RayMapper& mapper) {
    const CameraModel& c = mapper.camera();
    if (is_plain(c)) return;
    const LevelCamera level = half_camera(c);
    const int width = c.width_px / 2;
    const int height = c.height_px / 2;
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            const Eigen::Vector2d at(
                mapper.pixel({(u - level.cx_px) / level.fx_px, (v - level.cy_px) / level.fy_px}));
            const Eigen::Vector2d half((at.x() - 0.5) / 2, (at.y() - 0.5) / 2);
            const bool is_inside =
                half.x() >= 0.0 && half.y() >= 0.0 && half.x() < width - 1 && half.y() < height - 1;
            Sample sample;
            if (is_inside) {
                const int x = static_cast<int>(half.x());
                const int y = static_cast<int>(half.y());
                sample = {y * width + x, static_cast<float>(half.x() - x), static_cast<float>(half.y() - y)};
            }
            samples_.push_back(sample);
        }
    }
}

void LevelMapping::apply(const ImageView& image, const RayMapper& mapper, LevelImage& out) {
    const int width = image.width_px / 2;
    const int height = image.height_px / 2;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    out.width = width;
    out.height = height;
    out.camera = half_camera(mapper.camera());
    out.vignetting = 0.0;
    out.grey.resize(pixels);
    if (samples_.empty()) {
        halve(image, width, height, out.grey.data());
    } else {
        half_.resize(pixels);
        halve(image, width, height, half_.data());
        for (std::size_t i = 0; i < pixels; ++i) {
            const Sample& s = samples_[i];
            if (s.index < 0) {
                out.grey[i] = std::numeric_limits<float>::quiet_NaN();
                continue;
            }
            const float* const p = half_.data() + s.index;
            const float upper = p[0] + s.x * (p[1] - p[0]);
            const float lower = p[width] + s.x * (p[width + 1] - p[width]);
            out.grey[i] = upper + s.y * (lower - upper);
        }
    }
}

}  // namespace flownav::obstacles
