#pragma once
#include "flownav/obstacles/floor_warp.h"
#include "rows.h"

namespace flownav::obstacles {

inline rows::Reference rows_reference(const LevelImage& image) {
    return {image.grey.data(), image.width, image.height};
}

/// Places in the reference from which the floor of row `v` came.
inline rows::Places floor_places(const PairWarp& warp, int v) {
    const Eigen::Matrix3d H = floor_homography(warp);
    const auto at = [&](int i) { return static_cast<float>(H(i, 1) * v + H(i, 2)); };
    const auto per_column = [&](int i) { return static_cast<float>(H(i, 0)); };
    return {at(0), per_column(0), at(1), per_column(1), at(2), per_column(2)};
}

}  // namespace flownav::obstacles
