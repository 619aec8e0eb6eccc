#include "flownav/obstacles/floor_comparison.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "flownav/math/order_statistic.h"
#include "row_warp.h"

namespace flownav::obstacles {
namespace {

constexpr int tile_px = 16;  // of the local difference of brightness
constexpr float offset_clip_per_noise = 2.5F;
constexpr float offset_prior_px = 6.0F;  // pixels without a difference, added to each tile
constexpr double near_floor_m = 1.75;
constexpr int samples_min = 100;      // costs that tell the noise
constexpr double usual_cost = 0.227;  // median of the costs when the noise is right: that of chi^2 / 2
constexpr int sparse_px = 4;          // spacing of the pixels that measure gain, fall-off and noise
constexpr float dark_grey = 20.0F;    // darker pixels do not tell gain and fall-off
constexpr double ratio_limit = 0.1;   // of brightness, from its median

/// Columns begin to end - 1.
struct Columns {
    int begin = 0;
    int end = 0;
};

/// The columns of the strips in row `v`, without those at the border of the image.
Columns columns_of(const StripGrid& grid, const LevelImage& image, const StripRange& strips, int v) {
    return {std::max(1, strip_column(grid, image, strips.first, v)),
            std::min(image.width - 1, strip_column(grid, image, strips.last, v))};
}

float* row_of(std::vector<float>& plane, const LevelImage& image, int v) {
    return plane.data() + static_cast<std::ptrdiff_t>(v) * image.width;
}

/// The loops over the pixels of one pair share these.
struct Pair {
    const LevelImage& reference;
    const LevelImage& newer;
    const PairWarp& warp;
    const StripGrid grid;
    const StripRange strips;
    const float noise;

    int first_row() const { return grid.top_row; }
    int last_row() const { return std::min(newer.height - 1, grid.cells * cell_rows); }
};

/// Grey levels of the reference at the places from which the floor came; NaN outside.
void warp_floor(const Pair& pair, std::vector<float>& out) {
    out.resize(pair.newer.grey.size());
    for (int v = pair.first_row(); v < pair.last_row(); ++v) {
        const Columns columns = columns_of(pair.grid, pair.newer, pair.strips, v);
        rows::functions().warp(rows_reference(pair.reference), floor_places(pair.warp, v), columns.begin,
                               columns.end, row_of(out, pair.newer, v));
    }
}

/// Calls f(u, v, ratio of brightness) for a sparse set of bright pixels.
template <typename F>
void for_each_ratio(const Pair& pair, std::vector<float>& warped, F f) {
    for (int v = pair.first_row(); v < pair.last_row(); v += sparse_px) {
        const float* const before = row_of(warped, pair.newer, v);
        const float* const now = pair.newer.row(v);
        const Columns columns = columns_of(pair.grid, pair.newer, pair.strips, v);
        for (int u = columns.begin; u < columns.end; u += sparse_px)
            if (before[u] > dark_grey && now[u] > dark_grey) f(u, v, now[u] / before[u]);
    }
}

/// Median of the ratio of brightness, and what is left of the fall-off toward the corners: the ratio changes
/// with the difference of the squared radii.
void measure_brightness(const Pair& pair, FloorComparison& out) {
    out.ratios.clear();
    for_each_ratio(pair, out.warped, [&](int, int, float ratio) { out.ratios.push_back(ratio); });
    out.gain = out.ratios.empty() ? 1.0 : nth_smallest(out.ratios, out.ratios.size() / 2);
    const double radius2 = corner_radius_px(pair.newer) * corner_radius_px(pair.newer);
    const Eigen::Vector2d middle(0.5 * (pair.newer.width - 1), 0.5 * (pair.newer.height - 1));
    const Eigen::Matrix3d H = floor_homography(pair.warp);
    double xx = 1e-3;
    double xy = 0.0;
    for_each_ratio(pair, out.warped, [&](int u, int v, float ratio) {
        const double y = ratio / out.gain - 1.0;
        if (std::abs(y) > ratio_limit) return;
        const Eigen::Vector2d from = (H * Eigen::Vector3d(u, v, 1.0)).hnormalized();
        const double x =
            ((from - middle).squaredNorm() - (Eigen::Vector2d(u, v) - middle).squaredNorm()) / radius2;
        xx += x * x;
        xy += x * y;
    });
    out.vignetting = xy / xx;
}

int tiles_of(int pixels) {
    return (pixels + tile_px - 1) / tile_px;
}

/// Mean difference of brightness a tile, from every second pixel of every second row; large differences count
/// as much as small ones.
void measure_offsets(const Pair& pair, FloorComparison& out) {
    const int columns = tiles_of(pair.newer.width);
    const float limit = offset_clip_per_noise * pair.noise;
    const auto gain = static_cast<float>(out.gain);
    const auto tiles =
        static_cast<std::size_t>(columns) * static_cast<std::size_t>(tiles_of(pair.newer.height));
    out.offset.assign(tiles, 0.0F);
    out.offset_pixels.assign(tiles, offset_prior_px / 4.0F);
    for (int v = pair.first_row(); v < pair.last_row(); v += 2) {
        const float* const before = row_of(out.warped, pair.newer, v);
        const float* const now = pair.newer.row(v);
        const Columns inside = columns_of(pair.grid, pair.newer, pair.strips, v);
        const std::size_t row = static_cast<std::size_t>(v / tile_px) * static_cast<std::size_t>(columns);
        for (int u = inside.begin; u < inside.end; u += 2) {
            const float e = now[u] - gain * before[u];
            if (e != e) continue;
            const std::size_t tile = row + static_cast<std::size_t>(u / tile_px);
            out.offset[tile] += std::min(std::max(e, -limit), limit);
            out.offset_pixels[tile] += 1.0F;
        }
    }
    for (std::size_t i = 0; i < tiles; ++i) out.offset[i] /= out.offset_pixels[i];
}

void fill_row(const Pair& pair, int v, const Columns& columns, FloorComparison& out) {
    const LevelImage& image = pair.newer;
    const float* const tiles =
        out.offset.data() + static_cast<std::ptrdiff_t>(v / tile_px) * tiles_of(image.width);
    for (int u = 0; u < image.width; ++u) out.row_offset[static_cast<std::size_t>(u)] = tiles[u / tile_px];
    rows::CostRow row;
    row.above = image.row(v - 1);
    row.now = image.row(v);
    row.below = image.row(v + 1);
    row.before = row_of(out.warped, image, v);
    row.offset = out.row_offset.data();
    row.places = floor_places(pair.warp, v);
    row.v = static_cast<float>(v);
    row.w0 = static_cast<float>(pair.warp.floor[1] * v + pair.warp.floor[2]);
    row.w1 = static_cast<float>(pair.warp.floor[0]);
    row.bx = static_cast<float>(pair.warp.B[0]);
    row.by = static_cast<float>(pair.warp.B[1]);
    row.bz = static_cast<float>(pair.warp.B[2]);
    row.gain = static_cast<float>(out.gain);
    row.noise = pair.noise;
    row.cost = out.row_cost.data();
    row.steepness2 = out.row_steepness2.data();
    row.properties = out.row_properties.data();
    rows::functions().costs(row, columns.begin, columns.end);
}

/// Moves the counts of the pixels of one group of rows into its cells.
void flush_counts(const Pair& pair, int cell, FloorComparison& out) {
    for (int s = pair.strips.first; s < pair.strips.last; ++s) {
        std::uint16_t* const counts =
            out.property_counts.data() + static_cast<std::ptrdiff_t>(s) * rows::combinations;
        FloorCell& c = out.cells[pair.grid.index(cell, s)];
        for (int bits = 0; bits < rows::combinations; ++bits) {
            const int n = counts[bits];
            if (n == 0) continue;
            const auto add = [n](std::uint16_t& sum, bool counted) {
                if (counted) sum = static_cast<std::uint16_t>(sum + n);
            };
            const bool informative = (bits & rows::informative_bit) != 0;
            add(c.pixels, (bits & rows::seen_bit) != 0);
            add(c.edges, (bits & rows::edge_bit) != 0);
            add(c.compared, (bits & rows::compared_bit) != 0);
            add(c.misfits, (bits & rows::misfit_bit) != 0);
            add(c.floor, informative && (bits & rows::floor_bit) != 0);
            add(c.not_floor, informative && (bits & rows::misfit_bit) != 0);
            counts[bits] = 0;
        }
    }
}

Misfit misfit_at(const Pair& pair, const FloorComparison& data, int u, int v, int strip) {
    const float* const now = pair.newer.row(v) + u;
    const float dx = now[1] - now[-1];
    const float dy = now[pair.newer.width] - now[-pair.newer.width];
    const auto gain = static_cast<float>(data.gain);
    const auto i = static_cast<std::size_t>(u);
    return {static_cast<std::int16_t>(u),
            static_cast<std::int16_t>(v),
            static_cast<std::int16_t>(strip),
            std::abs(dx) >= std::abs(dy),
            (now[0] - data.row_offset[i]) / gain,
            data.row_steepness2[i],
            data.row_cost[i]};
}

/// Counts the properties of the pixels of a row and collects the pixels that do not fit.
void count_row(const Pair& pair, int v, const Columns& columns, FloorComparison& out) {
    const int* const properties = out.row_properties.data();
    for_each_strip(pair.grid, pair.newer, pair.strips, v, [&](int strip, int begin, int end) {
        std::uint16_t* const counts =
            out.property_counts.data() + static_cast<std::ptrdiff_t>(strip) * rows::combinations;
        for (int u = std::max(begin, columns.begin); u < std::min(end, columns.end); ++u) {
            ++counts[properties[u]];
            if ((properties[u] & rows::misfit_bit) != 0)
                out.unsorted.push_back(misfit_at(pair, out, u, v, strip));
        }
    });
}

/// Rows without floor: edges only.
void count_edges(const Pair& pair, int v, FloorComparison& out) {
    const float edge = rows::edge_per_noise * pair.noise;
    const float edge2 = edge * edge;
    const float* const now = pair.newer.row(v);
    const int width = pair.newer.width;
    for_each_strip(pair.grid, pair.newer, pair.strips, v, [&](int strip, int begin, int end) {
        FloorCell& cell = out.cells[pair.grid.index(v / cell_rows, strip)];
        for (int u = std::max(begin, 1); u < std::min(end, width - 1); ++u) {
            const float gx = 0.5F * (now[u + 1] - now[u - 1]);
            const float gy = 0.5F * (now[u + width] - now[u - width]);
            const float g2 = gx * gx + gy * gy;
            if (g2 == g2) ++cell.pixels;
            if (g2 > 1.5F * edge2) ++cell.edges;
        }
    });
}

/// Sorts the misfits by strip; those of one strip stay in their order.
void sort_by_strip(const StripGrid& grid, FloorComparison& out) {
    out.count.assign(static_cast<std::size_t>(grid.strips) + 1, 0);
    for (const Misfit& m : out.unsorted) ++out.count[static_cast<std::size_t>(m.strip) + 1];
    for (std::size_t i = 1; i < out.count.size(); ++i) out.count[i] += out.count[i - 1];
    out.misfits.resize(out.unsorted.size());
    for (const Misfit& m : out.unsorted)
        out.misfits[static_cast<std::size_t>(out.count[static_cast<std::size_t>(m.strip)]++)] = m;
}

/// Median of the costs, over a histogram.
class MedianCost {
  public:
    void add(float cost) {
        ++histogram_[static_cast<std::size_t>(cost * bins_per_unit)];
        ++count_;
    }
    double value() const {
        int sum = 0;
        std::size_t bin = 0;
        while (2 * (sum += histogram_[bin]) < count_) ++bin;
        return (static_cast<double>(bin) + 0.5) / bins_per_unit;
    }
    int count() const { return count_; }

  private:
    static constexpr float bins_per_unit = 64.0F;
    std::array<int, static_cast<std::size_t>(rows::cost_max* bins_per_unit) + 1> histogram_{};
    int count_ = 0;
};

void add_costs(const Columns& columns, const FloorComparison& data, MedianCost& median) {
    for (int u = columns.begin; u < columns.end; u += 2) {
        const auto i = static_cast<std::size_t>(u);
        if ((data.row_properties[i] & rows::compared_bit) != 0) median.add(data.row_cost[i]);
    }
}

void measure_fit(const Pair& pair, FloorComparison& out) {
    int good = 0;
    int all = 0;
    for (int cell = pair.grid.top_row / cell_rows + 1; cell < pair.grid.cells; ++cell) {
        if (cell_floor_m(pair.newer.camera, cell) > near_floor_m) continue;
        for (int s = pair.strips.first; s < pair.strips.last; ++s) {
            const FloorCell& c = out.cells[pair.grid.index(cell, s)];
            good += c.floor;
            all += c.floor + c.not_floor;
        }
    }
    out.near_informative = all;
    out.fit_share = all > 0 ? static_cast<double>(good) / all : 0.0;
}

void make_room(const Pair& pair, FloorComparison& out) {
    const auto width = static_cast<std::size_t>(pair.newer.width);
    out.noise = pair.noise;
    out.cells.assign(pair.grid.size(), FloorCell{});
    out.unsorted.clear();
    out.row_offset.resize(width);
    out.row_cost.resize(width);
    out.row_steepness2.resize(width);
    out.row_properties.resize(width);
    out.property_counts.assign(static_cast<std::size_t>(pair.grid.strips * rows::combinations), 0);
}

}  // namespace

void reserve(FloorComparison& comparison, std::size_t width, std::size_t height) {
    const std::size_t pixels = width * height;
    const std::size_t tiles = (width / tile_px + 1) * (height / tile_px + 1);
    comparison.cells.reserve(strips_max * (height / cell_rows + 1));
    comparison.misfits.reserve(pixels);
    comparison.warped.reserve(pixels);
    comparison.offset.reserve(tiles);
    comparison.offset_pixels.reserve(tiles);
    comparison.unsorted.reserve(pixels);
    comparison.count.reserve(strips_max + 1);
    comparison.ratios.reserve((width / sparse_px + 1) * (height / sparse_px + 1));
    comparison.row_offset.reserve(width);
    comparison.row_cost.reserve(width);
    comparison.row_steepness2.reserve(width);
    comparison.row_properties.reserve(width);
    comparison.property_counts.reserve(strips_max * static_cast<std::size_t>(rows::combinations));
}

void compare_with_floor(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                        double noise, const StripRange& strips, FloorComparison& out) {
    const Pair pair{reference, newer, warp, strip_grid(newer), strips, static_cast<float>(noise)};
    make_room(pair, out);
    warp_floor(pair, out.warped);
    measure_brightness(pair, out);
    measure_offsets(pair, out);
    MedianCost median;
    for (int v = 1; v < std::min(pair.first_row(), pair.last_row()); ++v) count_edges(pair, v, out);
    for (int v = pair.first_row(); v < pair.last_row(); ++v) {
        const Columns columns = columns_of(pair.grid, newer, strips, v);
        fill_row(pair, v, columns, out);
        count_row(pair, v, columns, out);
        if (v % sparse_px == 0) add_costs(columns, out, median);
        if ((v + 1) % cell_rows == 0 || v + 1 == pair.last_row()) flush_counts(pair, v / cell_rows, out);
    }
    sort_by_strip(pair.grid, out);
    if (median.count() >= samples_min) out.noise = noise * std::sqrt(median.value() / usual_cost);
    measure_fit(pair, out);
}

}  // namespace flownav::obstacles
