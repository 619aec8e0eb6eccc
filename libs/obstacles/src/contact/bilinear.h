#pragma once
#include "flownav/obstacles/level_image.h"

namespace flownav::obstacles {

/// True when sample() may be called at (x, y).
inline bool can_sample(const LevelImage& image, float x, float y) {
    return x >= 0.0F && y >= 0.0F && x < static_cast<float>(image.width - 1) &&
           y < static_cast<float>(image.height - 1);
}

/// Grey level between four pixels; NaN where the camera did not look.
inline float sample(const LevelImage& image, float x, float y) {
    const int u = static_cast<int>(x);
    const int v = static_cast<int>(y);
    const float* const p = image.row(v) + u;
    const float dx = x - static_cast<float>(u);
    const float dy = y - static_cast<float>(v);
    const float upper = p[0] + dx * (p[1] - p[0]);
    const float lower = p[image.width] + dx * (p[image.width + 1] - p[image.width]);
    return upper + dy * (lower - upper);
}

}  // namespace flownav::obstacles
