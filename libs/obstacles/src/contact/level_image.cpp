#include "flownav/obstacles/level_image.h"

#include <algorithm>
#include <cmath>

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

/// Divides by 1 - vignetting r^2.
void flatten(LevelImage& image, double vignetting) {
    if (vignetting == 0.0) return;
    const double radius_px = corner_radius_px(image);
    const auto per_px2 = static_cast<float>(vignetting / (radius_px * radius_px));
    const auto middle = static_cast<float>(0.5 * (image.width - 1));
    const float middle_v = 0.5F * static_cast<float>(image.height - 1);
    for (int v = 0; v < image.height; ++v) {
        float* const row = image.row(v);
        const float dy = static_cast<float>(v) - middle_v;
        for (int u = 0; u < image.width; ++u) {
            const float dx = static_cast<float>(u) - middle;
            row[u] /= 1.0F - per_px2 * (dx * dx + dy * dy);
        }
    }
}

/// Longest run of samples inside the image.
LevelImage::Span longest_run(const std::vector<int>& inside) {
    LevelImage::Span best;
    LevelImage::Span run;
    for (int u = 0; u < static_cast<int>(inside.size()); ++u) {
        run = inside[static_cast<std::size_t>(u)] ? LevelImage::Span{run.begin, u + 1}
                                                  : LevelImage::Span{u + 1, u + 1};
        if (run.end - run.begin > best.end - best.begin) best = run;
    }
    return best;
}

}  // namespace

double corner_radius_px(const LevelImage& image) {
    return 0.5 * std::hypot(image.width, image.height);
}

LevelMapping::LevelMapping(const RayMapper& mapper) {
    const CameraModel& c = mapper.camera();
    if (is_plain(c)) return;
    const LevelCamera level = half_camera(c);
    const int width = c.width_px / 2;
    const int height = c.height_px / 2;
    std::vector<int> inside(static_cast<std::size_t>(width));
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            const Eigen::Vector2d at(
                mapper.pixel({(u - level.cx_px) / level.fx_px, (v - level.cy_px) / level.fy_px}));
            const Eigen::Vector2d half((at.x() - 0.5) / 2, (at.y() - 0.5) / 2);
            const bool is_inside =
                half.x() >= 0.0 && half.y() >= 0.0 && half.x() < width - 1 && half.y() < height - 1;
            inside[static_cast<std::size_t>(u)] = is_inside;
            Sample sample;
            if (is_inside) {
                const int x = static_cast<int>(half.x());
                const int y = static_cast<int>(half.y());
                sample = {y * width + x, static_cast<float>(half.x() - x), static_cast<float>(half.y() - y)};
            }
            samples_.push_back(sample);
        }
        valid_.push_back(longest_run(inside));
    }
}

void LevelMapping::apply(const ImageView& image, const RayMapper& mapper, double vignetting,
                         LevelImage& out) {
    const int width = image.width_px / 2;
    const int height = image.height_px / 2;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    out.width = width;
    out.height = height;
    out.camera = half_camera(mapper.camera());
    out.grey.resize(pixels);
    if (samples_.empty()) {
        out.valid.assign(static_cast<std::size_t>(height), {0, width});
        halve(image, width, height, out.grey.data());
    } else {
        out.valid = valid_;
        half_.resize(pixels);
        halve(image, width, height, half_.data());
        for (std::size_t i = 0; i < pixels; ++i) {
            const Sample& s = samples_[i];
            if (s.index < 0) {
                out.grey[i] = 0.0F;
                continue;
            }
            const float* const p = half_.data() + s.index;
            const float upper = p[0] + s.x * (p[1] - p[0]);
            const float lower = p[width] + s.x * (p[width + 1] - p[width]);
            out.grey[i] = upper + s.y * (lower - upper);
        }
    }
    flatten(out, vignetting);
}

}  // namespace flownav::obstacles
