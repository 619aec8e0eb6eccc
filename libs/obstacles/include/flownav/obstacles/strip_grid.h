#pragma once
#include <cmath>
#include <vector>

#include "flownav/obstacles/level_image.h"

namespace flownav::obstacles {

constexpr double strip_tangent = 0.05;  ///< width of a strip of bearings, as tangent
constexpr int cell_rows = 4;            ///< rows of a cell
constexpr double floor_max_m = 8.0;     ///< floor farther away is not compared

constexpr int strips_max = 122;  ///< of any camera: tangents up to 3 on either side

/// Cells of the image: strips of bearings, which are vertical in the world, times groups of rows.
struct StripGrid {
    int first = 0;  ///< strip i covers the tangents (first + i) * strip_tangent to the right and up
    int strips = 0;
    int cells = 0;        ///< groups of rows, from the top of the image
    int top_row = 0;      ///< first row that shows floor nearer than floor_max_m
    int horizon_row = 0;  ///< first row below the horizon; may lie outside the image

    std::size_t index(int cell, int strip) const {
        return static_cast<std::size_t>(cell) * static_cast<std::size_t>(strips) +
               static_cast<std::size_t>(strip);
    }
    std::size_t size() const { return static_cast<std::size_t>(cells) * static_cast<std::size_t>(strips); }
};

StripGrid strip_grid(const LevelImage& image);

/// Strips first to last - 1 of a StripGrid.
struct StripRange {
    int first = 0;
    int last = 0;
};

/// First column of a strip in row `v`, within the image; the strip ends where the next begins.
inline int strip_column(const StripGrid& grid, const LevelImage& image, int strip, int v) {
    const double column = image.camera.column_of((grid.first + strip) * strip_tangent, v);
    if (!(column > 0.0)) return 0;
    return column < image.width ? static_cast<int>(std::ceil(column)) : image.width;
}

/// Calls f(strip, begin, end) for the columns begin to end - 1 of every strip of `range` in row `v`.
template <typename F>
void for_each_strip(const StripGrid& grid, const LevelImage& image, const StripRange& range, int v, F f) {
    int begin = strip_column(grid, image, range.first, v);
    for (int s = range.first; s < range.last; ++s) {
        const int end = strip_column(grid, image, s + 1, v);
        if (end > begin) f(s, begin, end);
        begin = end;
    }
}

/// Forward distance of the floor at the middle row of a cell; below the horizon only.
inline double cell_floor_m(const LevelCamera& camera, int cell) {
    return camera.floor_m(cell * cell_rows + 0.5 * (cell_rows - 1));
}

}  // namespace flownav::obstacles
