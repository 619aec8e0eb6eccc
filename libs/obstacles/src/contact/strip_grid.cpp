#include "flownav/obstacles/strip_grid.h"

#include <algorithm>
#include <cmath>

namespace flownav::obstacles {

StripGrid strip_grid(const LevelImage& image) {
    const LevelCamera& c = image.camera;
    StripGrid grid;
    double left = 0.0;
    double right = 0.0;
    for (const int v : {0, image.height - 1}) {
        const double forward = c.forward_of_ray(v);
        if (forward <= 0.1) continue;
        left = std::min(left, -c.cx_px / c.fx_px / forward);
        right = std::max(right, (image.width - 1 - c.cx_px) / c.fx_px / forward);
    }
    grid.first = static_cast<int>(std::floor(std::max(left, -3.0) / strip_tangent));
    grid.strips = static_cast<int>(std::ceil(std::min(right, 3.0) / strip_tangent)) - grid.first;
    grid.cells = image.height / cell_rows;
    const double horizon = std::ceil(c.row_of(0.0));
    const double top = std::ceil(c.row_of(c.height_m / floor_max_m));
    grid.horizon_row = static_cast<int>(std::clamp(horizon, -1e4, 1e4));
    grid.top_row = static_cast<int>(std::clamp(top, 1.0, std::max(1.0, static_cast<double>(image.height))));
    return grid;
}

}  // namespace flownav::obstacles
