#include "flownav/obstacles/floor_comparison.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "bilinear.h"
#include "flownav/math/order_statistic.h"
#include "row_warp.h"

namespace flownav::obstacles {
namespace {

constexpr int tile_px = 16;  // of the local difference of brightness
constexpr float offset_clip_per_noise = 2.5F;
constexpr float offset_prior_px = 6.0F;  // pixels without a difference, added to each tile
constexpr double near_floor_m = 1.75;
constexpr int samples_min = 100;         // costs that tell the noise
constexpr double usual_cost = 0.227;     // median of the costs when the noise is right: that of chi^2 / 2
constexpr int sparse_px = 8;             // spacing of the pixels that measure gain and fall-off
constexpr double quarter_nearer = 1.25;  // of inverse distance
constexpr int noise_rows = 4;            // every fourth row measures the noise
constexpr float dark_grey = 20.0F;       // darker pixels do not tell gain and fall-off
constexpr double ratio_limit = 0.1;      // of brightness, from its median
constexpr double far_m = 5.5;            // what is farther away is background
constexpr double far_step_px = 0.7;      // between the places where background may have been,
constexpr double far_steps_max = 60.0;   // at the most

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
    int last_row_above() const { return std::min(first_row(), last_row()); }
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

rows::CostRow row_at(const Pair& pair, int v, FloorComparison& out) {
    const LevelImage& image = pair.newer;
    rows::CostRow row{};
    row.above = image.row(v - 1);
    row.now = image.row(v);
    row.below = image.row(v + 1);
    row.before = row_of(out.warped, image, v);
    row.offset = out.offset.data() + static_cast<std::ptrdiff_t>(v / tile_px) * image.width;
    row.places = floor_places(pair.warp, v);
    row.v = static_cast<float>(v);
    row.w0 = static_cast<float>(pair.warp.floor[1] * v + pair.warp.floor[2]);
    row.w1 = static_cast<float>(pair.warp.floor[0]);
    row.bx = static_cast<float>(pair.warp.B[0]);
    row.by = static_cast<float>(pair.warp.B[1]);
    row.bz = static_cast<float>(pair.warp.B[2]);
    row.gain = static_cast<float>(out.gain);
    row.noise = pair.noise;
    row.cost = row_of(out.cost, image, v);
    row.steepness2 = row_of(out.steepness2, image, v);
    row.counts = out.row_counts.data();
    row.evidence = out.row_evidence.data();
    return row;
}

/// Mean difference of brightness a tile, from every second row of pixels, repeated for each column; large
/// differences count as much as small ones.
void measure_offsets(const Pair& pair, FloorComparison& out) {
    const int width = pair.newer.width;
    const float limit = offset_clip_per_noise * pair.noise;
    out.offset.assign(static_cast<std::size_t>(width * tiles_of(pair.newer.height)), 0.0F);
    for (int v0 = pair.first_row() / tile_px * tile_px; v0 < pair.last_row(); v0 += tile_px) {
        float* const sums = out.offset.data() + static_cast<std::ptrdiff_t>(v0 / tile_px) * width;
        out.row_numbers.assign(static_cast<std::size_t>(width), 0.0F);
        for (int v = std::max(v0, pair.first_row()); v < std::min(v0 + tile_px, pair.last_row()); v += 2) {
            const Columns columns = columns_of(pair.grid, pair.newer, pair.strips, v);
            rows::functions().differences(row_at(pair, v, out), limit, columns.begin, columns.end, sums,
                                          out.row_numbers.data());
        }
        for (int u0 = 0; u0 < width; u0 += tile_px) {
            float* const end = sums + std::min(u0 + tile_px, width);
            const float sum = std::accumulate(sums + u0, end, 0.0F);
            const float* const numbers = out.row_numbers.data();
            const float number = std::accumulate(numbers + u0, numbers + (end - sums), offset_prior_px / 2);
            std::fill(sums + u0, end, sum / number);
        }
    }
}

/// Calls f(packed sum of at most 255 pixels) for the pixels begin to end - 1.
template <typename F>
void for_each_sum(const rows::Packed* values, int begin, int end, F f) {
    constexpr int most = 255;
    for (int from = begin; from < end; from += most)
        f(std::accumulate(values + from, values + std::min(from + most, end), rows::Packed{0}));
}

void add_to(std::uint16_t& count, rows::Packed number) {
    count = static_cast<std::uint16_t>(count + number);
}

void count_properties(const rows::Packed* counts, int begin, int end, FloorCell& cell) {
    for_each_sum(counts, begin, end, [&](rows::Packed sum) {
        add_to(cell.pixels, sum & 255U);
        add_to(cell.edges, sum >> 8 & 255U);
        add_to(cell.compared, sum >> 16 & 255U);
        add_to(cell.misfits, sum >> 24);
    });
}

void count_evidence(const rows::Packed* evidence, int begin, int end, FloorCell& cell) {
    for_each_sum(evidence, begin, end, [&](rows::Packed sum) {
        add_to(cell.floor, sum & 0xFFFFU);
        add_to(cell.not_floor, sum >> 16);
    });
}

/// Counts the properties of the pixels of a row and collects the pixels that do not fit.
void count_row(const Pair& pair, int v, const Columns& columns, FloorComparison& out) {
    const rows::Packed* const counts = out.row_counts.data();
    for_each_strip(pair.grid, pair.newer, pair.strips, v, [&](int strip, int first, int last) {
        const int begin = std::max(first, columns.begin);
        const int end = std::min(last, columns.end);
        FloorCell& cell = out.cells[pair.grid.index(v / cell_rows, strip)];
        const int before = cell.misfits;
        count_properties(counts, begin, end, cell);
        count_evidence(out.row_evidence.data(), begin, end, cell);
        if (cell.misfits == before) return;
        for (int u = begin; u < end; ++u)
            if ((counts[u] & rows::misfit_one) != 0)
                out.unsorted.push_back({strip, v * pair.newer.width + u});
    });
}

/// Cost of a pixel that was at `from` in the reference; 0 where the camera did not look.
double cost_at(const Pair& pair, const Misfit& pixel, const Eigen::Vector2d& from) {
    const auto x = static_cast<float>(from.x());
    const auto y = static_cast<float>(from.y());
    if (!can_sample(pair.reference, x, y)) return 0.0;
    const double e = pixel.grey - sample(pair.reference, x, y);
    const double flow2 = (from - Eigen::Vector2d(pixel.u, pixel.v)).squaredNorm();
    const double t2 = rows::position_error_px * rows::position_error_px +
                      rows::position_error_per_flow * rows::position_error_per_flow * flow2;
    const double cost = e * e / (2.0 * (pair.noise * pair.noise + t2 * pixel.gradient2));
    return std::isnan(cost) ? 0.0 : std::min<double>(cost, rows::cost_max);
}

/// Smallest cost of a pixel when what it shows is far away; one that is small enough ends the search.
double far_cost(const Pair& pair, const Misfit& pixel) {
    const Eigen::Vector3d at(pixel.u, pixel.v, 1.0);
    const Eigen::Vector3d infinite = pair.warp.A * at;
    const Eigen::Vector3d change = pair.warp.B * (pair.warp.forward.dot(at) / far_m);
    const double way_px = ((infinite + change).hnormalized() - infinite.hnormalized()).norm();
    const int steps = 1 + static_cast<int>(std::min(way_px / far_step_px, far_steps_max));
    double least = rows::cost_max;
    for (int i = 0; i <= steps && least > rows::misfit_cost; ++i)
        least = std::min(least, cost_at(pair, pixel, (infinite + change * i / steps).hnormalized()));
    return least;
}

/// Costs of the pixels of a row above the floor that lie on upright edges, if they are far away; 0 elsewhere.
void measure_far_costs(const Pair& pair, int v, const Columns& columns, FloorComparison& out) {
    const float* const now = pair.newer.row(v);
    const auto width = static_cast<std::ptrdiff_t>(pair.newer.width);
    float* const costs = row_of(out.cost, pair.newer, v);
    float* const steepness2 = row_of(out.steepness2, pair.newer, v);
    for (int u = columns.begin; u < columns.end; ++u) {
        costs[u] = 0.0F;
        if ((out.row_counts[static_cast<std::size_t>(u)] & rows::edge_one) == 0) continue;
        const float dx = now[u + 1] - now[u - 1];
        const float dy = now[u + width] - now[u - width];
        if (std::abs(dx) < std::abs(dy)) continue;
        steepness2[u] = 0.25F * (dx * dx + dy * dy);
        const float grey = now[u] / static_cast<float>(out.gain);
        costs[u] = static_cast<float>(far_cost(pair, {u, v, true, grey, steepness2[u], 0.0F}));
    }
}

/// Collects the pixels on both sides of upright edges that do not move as if far away. The side that fits
/// both tells which contacts are too near.
void collect_upright_edges(const Pair& pair, int v, int strip, const Columns& own, const Columns& all,
                           FloorComparison& out) {
    const float* const costs = row_of(out.cost, pair.newer, v);
    for (int u = std::max(own.begin, all.begin + 1); u < std::min(own.end, all.end - 1); ++u) {
        const float worst = std::max({costs[u - 1], costs[u], costs[u + 1]});
        if (costs[u] > 0.0F && worst > rows::misfit_cost)
            out.unsorted.push_back({strip, v * pair.newer.width + u});
    }
}

/// Counts pixels and edges of the rows above the floor, and collects the upright edges of things that are
/// near: a thing as bright as the floor may show by them alone.
void look_above_floor(const Pair& pair, FloorComparison& out) {
    for (int v = 1; v < pair.last_row_above(); ++v) {
        rows::CostRow row{};
        row.above = pair.newer.row(v - 1);
        row.now = pair.newer.row(v);
        row.below = pair.newer.row(v + 1);
        row.noise = pair.noise;
        row.counts = out.row_counts.data();
        const Columns columns = columns_of(pair.grid, pair.newer, pair.strips, v);
        rows::functions().edges(row, columns.begin, columns.end);
        measure_far_costs(pair, v, columns, out);
        for_each_strip(pair.grid, pair.newer, pair.strips, v, [&](int strip, int first, int last) {
            const Columns own{std::max(first, columns.begin), std::min(last, columns.end)};
            count_properties(row.counts, own.begin, own.end,
                             out.cells[pair.grid.index(v / cell_rows, strip)]);
            collect_upright_edges(pair, v, strip, own, columns, out);
        });
    }
}

/// Sorts the misfits by strip; those of one strip stay in their order.
void sort_by_strip(const StripGrid& grid, FloorComparison& out) {
    out.first_misfit.assign(static_cast<std::size_t>(grid.strips) + 2, 0);
    for (const auto& m : out.unsorted) ++out.first_misfit[static_cast<std::size_t>(m.strip) + 2];
    for (std::size_t i = 2; i < out.first_misfit.size(); ++i) out.first_misfit[i] += out.first_misfit[i - 1];
    out.misfits.resize(out.unsorted.size());
    for (const auto& m : out.unsorted)
        out.misfits[out.first_misfit[static_cast<std::size_t>(m.strip) + 1]++] = m.pixel;
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

void add_costs(const Columns& columns, const float* cost, const FloorComparison& data, MedianCost& median) {
    for (int u = columns.begin; u < columns.end; u += 2) {
        const auto i = static_cast<std::size_t>(u);
        if ((data.row_counts[i] & rows::compared_one) != 0) median.add(cost[u]);
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
    out.cost.resize(pair.newer.grey.size());
    out.steepness2.resize(pair.newer.grey.size());
    out.row_counts.resize(width);
    out.row_evidence.resize(width);
    out.row_nearer.resize(width);
    out.row_preference.resize(width);
}

}  // namespace

void reserve(FloorComparison& comparison, std::size_t width, std::size_t height) {
    const std::size_t pixels = width * height;
    comparison.cells.reserve(strips_max * (height / cell_rows + 1));
    comparison.misfits.reserve(pixels);
    comparison.warped.reserve(pixels);
    comparison.offset.reserve(width * (height / tile_px + 1));
    comparison.unsorted.reserve(pixels);
    comparison.first_misfit.reserve(strips_max + 2);
    comparison.ratios.reserve((width / sparse_px + 1) * (height / sparse_px + 1));
    comparison.row_numbers.reserve(width);
    comparison.cost.reserve(pixels);
    comparison.steepness2.reserve(pixels);
    comparison.row_counts.reserve(width);
    comparison.row_evidence.reserve(width);
    comparison.row_nearer.reserve(width);
    comparison.row_preference.reserve(width);
}

void compare_with_floor(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                        double noise, const StripRange& strips, FloorComparison& out) {
    const Pair pair{reference, newer, warp, strip_grid(newer), strips, static_cast<float>(noise)};
    make_room(pair, out);
    warp_floor(pair, out.warped);
    measure_brightness(pair, out);
    measure_offsets(pair, out);
    look_above_floor(pair, out);
    MedianCost median;
    for (int v = pair.first_row(); v < pair.last_row(); ++v) {
        const Columns columns = columns_of(pair.grid, newer, strips, v);
        rows::functions().costs(row_at(pair, v, out), columns.begin, columns.end);
        count_row(pair, v, columns, out);
        if (v % noise_rows == 0) add_costs(columns, row_of(out.cost, newer, v), out, median);
    }
    sort_by_strip(pair.grid, out);
    if (median.count() >= samples_min) out.noise = noise * std::sqrt(median.value() / usual_cost);
    measure_fit(pair, out);
}

void measure_preferences(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                         double noise, FloorComparison& out) {
    const StripGrid grid = strip_grid(newer);
    const Pair pair{reference, newer, warp, grid, {0, grid.strips}, static_cast<float>(noise)};
    PairWarp nearer = warp;
    nearer.floor *= quarter_nearer;
    for (int v = pair.first_row(); v < pair.last_row(); ++v) {
        const Columns columns = columns_of(grid, newer, pair.strips, v);
        rows::CostRow row = row_at(pair, v, out);
        row.before_nearer = out.row_nearer.data();
        row.preference = out.row_preference.data();
        rows::functions().warp(rows_reference(reference), floor_places(nearer, v), columns.begin, columns.end,
                               out.row_nearer.data());
        rows::functions().preferences(row, columns.begin, columns.end);
        for_each_strip(grid, newer, pair.strips, v, [&](int strip, int first, int last) {
            const int begin = std::max(first, columns.begin);
            const int end = std::max(begin, std::min(last, columns.end));
            out.cells[grid.index(v / cell_rows, strip)].preference +=
                std::accumulate(row.preference + begin, row.preference + end, 0.0F);
        });
    }
}

Misfit misfit_at(const FloorComparison& data, const LevelImage& newer, int pixel) {
    const int u = pixel % newer.width;
    const int v = pixel / newer.width;
    const auto i = static_cast<std::size_t>(pixel);
    const float* const now = newer.grey.data() + pixel;
    const float dx = now[1] - now[-1];
    const float dy = now[newer.width] - now[-newer.width];
    const auto offset = static_cast<std::size_t>(v / tile_px * newer.width + u);
    return {u,
            v,
            std::abs(dx) >= std::abs(dy),
            (now[0] - data.offset[offset]) / static_cast<float>(data.gain),
            data.steepness2[i],
            data.cost[i]};
}

}  // namespace flownav::obstacles
