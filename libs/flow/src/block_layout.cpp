#include "flownav/flow/block_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nanoflann.hpp>
#include <numeric>

#include "flownav/core/plane_geometry.h"
#include "flownav/flow/kernel.h"

namespace flownav::flow {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

constexpr double half_block_px = (block_px - 1) / 2.0;
constexpr double density_floor = 0.2;  // smallest a y + b; nearer to the horizon the density is constant

/// Weights of candidates as a cumulative sum.
struct Cumulative {
    std::vector<double> upto;

    void add(double share) { upto.push_back(total() + share); }
    double total() const { return upto.empty() ? 0.0 : upto.back(); }
    std::size_t at_quantile(double quantile) const {
        const auto it = std::upper_bound(upto.begin(), upto.end(), quantile * total());
        return std::min<std::size_t>(it - upto.begin(), upto.size() - 1);
    }
};

/// Possible block corners of one image row, with their weights.
struct Row {
    std::vector<Vector2i> corner_px;
    Cumulative share;
};

/// Density of blocks over the image: its rows and their weights.
struct Density {
    std::vector<Row> rows;
    Cumulative share;
};

Row density_of_row(const RayMapper& mapper, int v, double focus_exclusion, bool window_only) {
    const CameraModel& camera = mapper.camera();
    const PlaneGeometry plane(camera.mount);
    Row row;
    for (int u = 0; u + block_px <= camera.width_px; u += 2) {
        const Vector2d centre(u + half_block_px, v + half_block_px);
        if (window_only && !in_ground_window(centre, camera)) continue;
        const Vector2d at = mapper.ray(centre);
        if (plane.e(at).norm() < focus_exclusion) continue;
        const double far = 1.0 / std::max(plane.below_horizon(at), density_floor);
        row.corner_px.emplace_back(u, v);
        row.share.add(far * far);
    }
    return row;
}

Density density_over(const RayMapper& mapper, double focus_exclusion, bool window_only) {
    Density density;
    for (int v = 0; v + block_px <= mapper.camera().height_px; ++v) {
        Row row = density_of_row(mapper, v, focus_exclusion, window_only);
        if (row.corner_px.empty()) continue;
        density.share.add(row.share.total());
        density.rows.push_back(std::move(row));
    }
    return density;
}

/// Appends `count` corners, distributed over the density by the two-dimensional golden-ratio sequence.
void sample_into(BlockLayout& layout, const Density& density, int count) {
    if (density.rows.empty()) return;
    constexpr double plastic = 1.32471795724474602596;  // x^3 = x + 1
    const auto fraction = [](double x) { return x - std::floor(x); };
    for (int i = 0; i < count; ++i) {
        const Row& row = density.rows[density.share.at_quantile(fraction(0.5 + i / plastic))];
        layout.corner_px.push_back(
            row.corner_px[row.share.at_quantile(fraction(0.5 + i / (plastic * plastic)))]);
    }
}

struct Cloud {
    std::vector<Vector2d> points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t dim) const { return points[i][static_cast<int>(dim)]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

/// Finds the nearest blocks of each block. v is scaled by `v_scale`, because a field's lines lie twice as far
/// apart as its columns.
std::vector<std::array<int, neighbours_max>> find_neighbours(const BlockLayout& layout, double v_scale) {
    Cloud cloud;
    for (const Vector2d& c : layout.centre_px) cloud.points.emplace_back(c.x(), c.y() * v_scale);
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2>;
    const Tree tree(2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    std::vector<std::array<int, neighbours_max>> table(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) {
        std::array<std::uint32_t, neighbours_max + 1> found{};
        std::array<double, neighbours_max + 1> distance2{};
        const std::size_t n =
            tree.knnSearch(cloud.points[i].data(), found.size(), found.data(), distance2.data());
        table[i].fill(-1);
        int kept = 0;
        for (std::size_t k = 0; k < n && kept < neighbours_max; ++k) {
            if (found[k] != static_cast<std::uint32_t>(i)) table[i][kept++] = static_cast<int>(found[k]);
        }
    }
    return table;
}

}  // namespace

BlockLayout place_blocks(const RayMapper& mapper, const FlowParams& params) {
    const CameraModel& camera = mapper.camera();
    BlockLayout layout;
    const int in_window = std::min(ground_window_min, params.blocks);
    sample_into(layout, density_over(mapper, params.focus_exclusion, true), in_window);
    const int anywhere = params.blocks - static_cast<int>(layout.size());
    sample_into(layout, density_over(mapper, params.focus_exclusion, false), anywhere);
    for (const Vector2i& c : layout.corner_px) {
        layout.centre_px.emplace_back(c.x() + half_block_px, c.y() + half_block_px);
        layout.in_ground_window.push_back(in_ground_window(layout.centre_px.back(), camera) ? 1 : 0);
    }
    set_reference(layout, mapper);
    layout.neighbours = find_neighbours(layout, camera.fx_px / camera.fy_px);
    return layout;
}

void set_reference(BlockLayout& layout, const RayMapper& reference) {
    layout.centre.resize(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) layout.centre[i] = reference.ray(layout.centre_px[i]);
}

BlockLayout every_nth(const BlockLayout& layout, std::size_t n) {
    BlockLayout part;
    for (std::size_t i = 0; i < layout.size(); i += n) {
        part.corner_px.push_back(layout.corner_px[i]);
        part.centre_px.push_back(layout.centre_px[i]);
        part.centre.push_back(layout.centre[i]);
        part.in_ground_window.push_back(layout.in_ground_window[i]);
    }
    return part;
}

}  // namespace flownav::flow
