#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "flownav/core/image_view.h"
#include "flownav/flow/kernel.h"

namespace flownav::flow {

/// Rounds a displacement to whole pixels. A component that is not finite, or not below 1e8 px, becomes 1e8
/// px, which moves the search window out of every image.
inline Eigen::Vector2i whole_px(const Eigen::Vector2d& displacement_px) {
    constexpr double far_px = 1e8;  // an int holds the sum of two
    const auto nearest = [](double value) {
        const bool usable = std::abs(value) < far_px;  // false for NaN
        return static_cast<int>(usable ? value + std::copysign(0.5, value) : far_px);
    };
    return {nearest(displacement_px.x()), nearest(displacement_px.y())};
}

/// Top left pixel of a displaced block; 64 bits cannot overflow.
inline Eigen::Matrix<std::int64_t, 2, 1> displaced(const Eigen::Vector2i& corner_px,
                                                   const Eigen::Vector2i& bias_px) {
    return corner_px.cast<std::int64_t>() + bias_px.cast<std::int64_t>();
}

/// True when a block (top left pixel `corner_px`, displaced by `bias_px`) lies inside the image.
inline bool contains_block(const ImageView& image, const Eigen::Vector2i& corner_px,
                           const Eigen::Vector2i& bias_px = Eigen::Vector2i::Zero()) {
    const auto at = displaced(corner_px, bias_px);
    return at.x() >= 0 && at.y() >= 0 && at.x() + block_px <= image.width_px &&
           at.y() + block_px <= image.height_px;
}

}  // namespace flownav::flow
