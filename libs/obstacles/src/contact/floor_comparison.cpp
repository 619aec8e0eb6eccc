#include "flownav/obstacles/floor_comparison.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bilinear.h"
#include "flownav/math/order_statistic.h"
#include "strip_grid.h"

namespace flownav::obstacles {
namespace {

constexpr int tile_px = 16;             // of the local difference of brightness
constexpr float misfit_cost = 2.0F;     // more: does not move as the floor
constexpr float fit_cost = 1.0F;        // less: does
constexpr float edge_per_noise = 4.3F;  // gradient of an edge
constexpr float offset_clip_per_noise = 3.7F;
constexpr float offset_prior_px = 6.0F;  // pixels without a difference, added to each tile
constexpr double near_floor_m = 1.75;
constexpr int sparse_px = 4;  // spacing of the pixels that measure gain and vignetting

/// A row of the homogeneous warp: X(u) = x0 + x1 u and so on, w(u) = w0 + w1 u.
struct RowWarp {
    RowWarp(const PairWarp& warp, int v) {
        const Eigen::Matrix3d H = floor_homography(warp);
        const auto at = [&](int i) { return static_cast<float>(H(i, 1) * v + H(i, 2)); };
        x0 = at(0);
        y0 = at(1);
        z0 = at(2);
        x1 = static_cast<float>(H(0, 0));
        y1 = static_cast<float>(H(1, 0));
        z1 = static_cast<float>(H(2, 0));
        w0 = static_cast<float>(warp.floor[1] * v + warp.floor[2]);
        w1 = static_cast<float>(warp.floor[0]);
        bx = static_cast<float>(warp.B[0]);
        by = static_cast<float>(warp.B[1]);
        bz = static_cast<float>(warp.B[2]);
    }
    float x0, x1, y0, y1, z0, z1, w0, w1, bx, by, bz;
};

/// Grey levels of the reference at the places from which the floor came; NaN outside.
void warp_floor(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp, int top_row,
                std::vector<float>& out) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    out.resize(newer.grey.size());
    for (int v = top_row; v < newer.height - 1; ++v) {
        const RowWarp row(warp, v);
        float* const to = out.data() + static_cast<std::ptrdiff_t>(v) * newer.width;
        for (int u = 0; u < newer.width; ++u) {
            const auto at = static_cast<float>(u);
            const float inverse = 1.0F / (row.z0 + row.z1 * at);
            const float x = (row.x0 + row.x1 * at) * inverse;
            const float y = (row.y0 + row.y1 * at) * inverse;
            to[u] = can_sample(reference, x, y) ? sample(reference, x, y) : nan;
        }
    }
}

/// Median of the ratio of brightness, and what is left of the fall-off toward the corners: the ratio changes
/// with the difference of the squared radii.
void measure_brightness(const LevelImage& newer, const PairWarp& warp, int top_row, FloorComparison& out) {
    out.ratios.clear();
    const auto for_each_pixel = [&](auto f) {
        for (int v = top_row; v < newer.height - 1; v += sparse_px) {
            const float* const before = out.warped.data() + static_cast<std::ptrdiff_t>(v) * newer.width;
            for (int u = 1; u < newer.width - 1; u += sparse_px)
                if (before[u] > 20.0F) f(u, v, newer.row(v)[u] / before[u]);
        }
    };
    for_each_pixel([&](int, int, float ratio) { out.ratios.push_back(ratio); });
    out.gain = out.ratios.empty() ? 1.0 : nth_smallest(out.ratios, out.ratios.size() / 2);
    const double radius2 = corner_radius_px(newer) * corner_radius_px(newer);
    const Eigen::Vector2d middle(0.5 * (newer.width - 1), 0.5 * (newer.height - 1));
    const Eigen::Matrix3d H = floor_homography(warp);
    double xx = 1e-3;
    double xy = 0.0;
    for_each_pixel([&](int u, int v, float ratio) {
        const double y = ratio / out.gain - 1.0;
        if (std::abs(y) > 0.1) return;
        const Eigen::Vector2d from = (H * Eigen::Vector3d(u, v, 1.0)).hnormalized();
        const double x =
            ((from - middle).squaredNorm() - (Eigen::Vector2d(u, v) - middle).squaredNorm()) / radius2;
        xx += x * x;
        xy += x * y;
    });
    out.vignetting = xy / xx;
}

/// Mean difference of brightness a tile; large differences count as much as small ones.
void measure_offsets(const LevelImage& newer, int top_row, double noise, FloorComparison& out) {
    const int columns = (newer.width + tile_px - 1) / tile_px;
    const int rows = (newer.height + tile_px - 1) / tile_px;
    const auto limit = static_cast<float>(offset_clip_per_noise * noise);
    const auto gain = static_cast<float>(out.gain);
    out.offset.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0.0F);
    for (int row = top_row / tile_px; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            float sum = 0.0F;
            float count = offset_prior_px;
            for (int v = std::max(top_row, row * tile_px);
                 v < std::min(newer.height - 1, (row + 1) * tile_px); ++v) {
                const float* const before = out.warped.data() + static_cast<std::ptrdiff_t>(v) * newer.width;
                const float* const now = newer.row(v);
                const int end = std::min(newer.width, (column + 1) * tile_px);
                for (int u = column * tile_px; u < end; ++u) {
                    const float e = now[u] - gain * before[u];
                    if (e != e) continue;
                    sum += std::min(std::max(e, -limit), limit);
                    count += 1.0F;
                }
            }
            out.offset[static_cast<std::size_t>(row * columns + column)] = sum / count;
        }
    }
}

/// Values of one row of pixels.
struct RowBuffers {
    float* error;      ///< of brightness, against the floor; NaN: not compared
    float* gradient2;  ///< squared
    float* cost;
    float* parallax;    ///< |gradient . d|, d: displacement that a quarter more inverse depth causes
    float* tolerance2;  ///< squared tolerance of position
};

void fill_row(const LevelImage& newer, const PairWarp& warp, int v, float noise, const FloorComparison& data,
              const RowBuffers& out) {
    const RowWarp row(warp, v);
    const float* const now = newer.row(v);
    const float* const before = data.warped.data() + static_cast<std::ptrdiff_t>(v) * newer.width;
    const int columns = (newer.width + tile_px - 1) / tile_px;
    const float* const offset = data.offset.data() + static_cast<std::ptrdiff_t>(v / tile_px) * columns;
    const auto gain = static_cast<float>(data.gain);
    for (int u = 0; u < newer.width; ++u) out.error[u] = now[u] - gain * before[u] - offset[u / tile_px];
    const auto height = static_cast<float>(v);
    for (int u = 1; u < newer.width - 1; ++u) {
        const auto at = static_cast<float>(u);
        const float inverse = 1.0F / (row.z0 + row.z1 * at);
        const float x = (row.x0 + row.x1 * at) * inverse;
        const float y = (row.y0 + row.y1 * at) * inverse;
        const float w = 0.25F * (row.w0 + row.w1 * at) * inverse;
        const float gx = 0.5F * (now[u + 1] - now[u - 1]);
        const float gy = 0.5F * (now[u + newer.width] - now[u - newer.width]);
        const float g2 = gx * gx + gy * gy;
        const float flow2 = (x - at) * (x - at) + (y - height) * (y - height);
        const float tolerance2 =
            position_error_px * position_error_px + position_error_per_flow * position_error_per_flow * flow2;
        const float along = gx * (row.bx - x * row.bz) + gy * (row.by - y * row.bz);
        const float e = out.error[u];
        out.gradient2[u] = g2;
        out.tolerance2[u] = tolerance2;
        out.parallax[u] = std::abs(along * w);
        out.cost[u] = std::min(e * e / (2.0F * (noise * noise + tolerance2 * g2)), cost_max);
    }
    for (const int u : {0, newer.width - 1}) out.error[u] = std::numeric_limits<float>::quiet_NaN();
}

/// True when a quarter more inverse depth would show in the pixel's brightness.
bool is_informative(float parallax, float gradient2, float tolerance2, float noise) {
    return parallax > 2.5F * noise && gradient2 > 1.5F * noise * noise &&
           parallax * parallax > std::max(0.25F, 4.0F * tolerance2) * gradient2;
}

/// Counts the pixels of a row into the cells and collects those that do not fit.
void count_row(const LevelImage& newer, const StripGrid& grid, int v, float noise, const RowBuffers& row,
               FloorComparison& out) {
    const float edge2 = edge_per_noise * noise * edge_per_noise * noise;
    const float* const now = newer.row(v);
    const auto gain = static_cast<float>(out.gain);
    const float* const before = out.warped.data() + static_cast<std::ptrdiff_t>(v) * newer.width;
    for_each_strip(grid, newer, v, [&](int strip, int begin, int end) {
        FloorCell& cell = out.cells[grid.index(v / cell_rows, strip)];
        for (int u = std::max(begin, 1); u < std::min(end, newer.width - 1); ++u) {
            ++cell.pixels;
            if (row.gradient2[u] > edge2) ++cell.edges;
            if (row.error[u] != row.error[u]) continue;
            ++cell.compared;
            const bool misfit = row.cost[u] > misfit_cost;
            if (misfit) ++cell.misfits;
            if (is_informative(row.parallax[u], row.gradient2[u], row.tolerance2[u], noise)) {
                if (row.cost[u] < fit_cost) ++cell.floor;
                if (misfit) ++cell.not_floor;
            }
            if (!misfit) continue;
            const float gx = now[u + 1] - now[u - 1];
            const float gy = now[u + newer.width] - now[u - newer.width];
            out.unsorted.push_back({static_cast<std::int16_t>(u), static_cast<std::int16_t>(v),
                                    static_cast<std::int16_t>(strip), std::abs(gx) >= std::abs(gy),
                                    (row.error[u] + gain * before[u]) / gain, row.gradient2[u], row.cost[u]});
        }
    });
}

/// Rows without floor: edges only.
void count_edges(const LevelImage& newer, const StripGrid& grid, int v, float noise, FloorComparison& out) {
    const float edge2 = edge_per_noise * noise * edge_per_noise * noise;
    const float* const now = newer.row(v);
    for_each_strip(grid, newer, v, [&](int strip, int begin, int end) {
        FloorCell& cell = out.cells[grid.index(v / cell_rows, strip)];
        for (int u = std::max(begin, 1); u < std::min(end, newer.width - 1); ++u) {
            const float gx = 0.5F * (now[u + 1] - now[u - 1]);
            const float gy = 0.5F * (now[u + newer.width] - now[u - newer.width]);
            ++cell.pixels;
            if (gx * gx + gy * gy > edge2) ++cell.edges;
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

/// Noise from the differences of brightness where the image is flat: a median over a histogram.
class NoiseMeter {
  public:
    explicit NoiseMeter(float noise) : flat2_(4.0F * noise * noise), bins_per_grey_(40.0F / noise) {}
    void add(float error, float gradient2) {
        if (!(gradient2 < flat2_)) return;
        const float bin = std::abs(error) * bins_per_grey_;
        ++histogram_[bin < bins ? static_cast<std::size_t>(bin) : bins - 1];
        ++count_;
    }
    double noise() const {
        if (count_ < 300) return 0.0;
        int sum = 0;
        std::size_t bin = 0;
        while (2 * (sum += histogram_[bin]) < count_) ++bin;
        return (static_cast<double>(bin) + 0.5) / bins_per_grey_ * 1.4826 / std::sqrt(2.0);
    }

  private:
    static constexpr std::size_t bins = 400;
    float flat2_;
    float bins_per_grey_;
    std::array<int, bins> histogram_{};
    int count_ = 0;
};

double near_fit_share(const LevelCamera& camera, const StripGrid& grid, const std::vector<FloorCell>& cells) {
    int good = 0;
    int all = 0;
    for (int cell = grid.top_row / cell_rows + 1; cell < grid.cells; ++cell) {
        if (cell_floor_m(camera, cell) > near_floor_m) continue;
        for (int s = 0; s < grid.strips; ++s) {
            good += cells[grid.index(cell, s)].floor;
            all += cells[grid.index(cell, s)].floor + cells[grid.index(cell, s)].not_floor;
        }
    }
    return all > 0 ? static_cast<double>(good) / all : 0.0;
}

}  // namespace

void compare_with_floor(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                        double noise, FloorComparison& out) {
    const StripGrid grid = strip_grid(newer);
    const auto sigma = static_cast<float>(noise);
    out.cells.assign(grid.size(), FloorCell{});
    out.unsorted.clear();
    warp_floor(reference, newer, warp, grid.top_row, out.warped);
    measure_brightness(newer, warp, grid.top_row, out);
    measure_offsets(newer, grid.top_row, noise, out);
    const auto width = static_cast<std::size_t>(newer.width);
    out.row.assign(5 * width, 0.0F);
    float* const r = out.row.data();
    const RowBuffers row{r, r + width, r + 2 * width, r + 3 * width, r + 4 * width};
    NoiseMeter meter(sigma);
    const int rows = std::min(newer.height - 1, grid.cells * cell_rows);
    for (int v = 1; v < std::min(grid.top_row, rows); ++v) count_edges(newer, grid, v, sigma, out);
    for (int v = grid.top_row; v < rows; ++v) {
        fill_row(newer, warp, v, sigma, out, row);
        count_row(newer, grid, v, sigma, row, out);
        if (v % sparse_px != 0) continue;
        for (int u = 1; u < newer.width - 1; u += 2)
            if (row.error[u] == row.error[u]) meter.add(row.error[u], row.gradient2[u]);
    }
    sort_by_strip(grid, out);
    out.noise = meter.noise();
    out.fit_share = near_fit_share(newer.camera, grid, out.cells);
}

}  // namespace flownav::obstacles
