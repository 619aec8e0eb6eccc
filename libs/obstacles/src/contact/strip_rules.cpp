#include "flownav/obstacles/strip_rules.h"

#include <algorithm>
#include <cmath>

#include "flownav/obstacles/strip_grid.h"

namespace flownav::obstacles {
namespace {

// Free floor.
constexpr int floor_min = 3;              // pixels of floor in a cell that is floor
constexpr double not_floor_share = 0.34;  // of them: largest number of pixels that are not
constexpr double gap_share = 0.2;         // of the distance: longest way without a cell of floor
constexpr double missing_max = 4.0;       // log-likelihood of texture that should have been seen
constexpr double contradiction = 1.5;     // added for a cell that is not floor
constexpr double presence_max = 0.97;
constexpr int presence_cells = 3;  // cells over which the presence of texture is measured
// Walls.
constexpr int above_horizon_cells = 2;
constexpr double continuing = 0.2;  // largest relative step of range between strips of one wall
constexpr int wall_neighbours = 2;  // of the four nearest strips

bool is_floor(const FloorCell& cell) {
    return cell.floor >= floor_min && cell.not_floor <= not_floor_share * cell.floor;
}

/// Share of the strips that show floor in this cell or the two nearer ones.
double presence(const StripGrid& grid, const std::vector<FloorCell>& cells, int cell) {
    int live = 0;
    int with_floor = 0;
    for (int s = 0; s < grid.strips; ++s) {
        bool in_view = false;
        bool seen = false;
        for (int c = cell; c < std::min(cell + presence_cells, grid.cells); ++c) {
            in_view |= cells[grid.index(c, s)].compared > 0;
            seen |= is_floor(cells[grid.index(c, s)]);
        }
        live += in_view;
        with_floor += seen;
    }
    return live > 0 ? std::min(static_cast<double>(with_floor) / live, presence_max) : 0.0;
}

double floor_end_m(const LevelImage& image, const StripGrid& grid, const std::vector<FloorCell>& cells,
                   const std::vector<double>& missing, int strip) {
    const int top = grid.top_row / cell_rows + 1;
    double end_m = 0.0;
    double reached_m = image.camera.floor_m(grid.cells * cell_rows - 1);  // lower border of the view
    double lacking = 0.0;
    for (int cell = grid.cells - 1; cell >= top; --cell) {
        const FloorCell& c = cells[grid.index(cell, strip)];
        const double far_m = image.camera.floor_m(cell * cell_rows);
        if (is_floor(c)) {
            end_m = reached_m = far_m;
            lacking = 0.0;
            continue;
        }
        if (c.compared > 0) lacking += missing[static_cast<std::size_t>(cell)];
        if (c.not_floor >= floor_min && c.not_floor > c.floor) lacking += contradiction;
        if (lacking > missing_max || far_m - reached_m > gap_share * std::max(1.0, far_m)) break;
    }
    return end_m;
}

/// Distance of the first edge below a surface that has none from above the horizon; 0: no such surface.
struct FirstEdge {
    double upper_m = 0.0;
    double lower_m = 0.0;  ///< lower rim of the edge
};

FirstEdge first_edge(const LevelImage& image, const StripGrid& grid, const std::vector<FloorCell>& cells,
                     int strip) {
    int cell = grid.horizon_row / cell_rows - above_horizon_cells;
    if (cell < 1) return {};
    for (; cell < grid.cells; ++cell) {
        const FloorCell& c = cells[grid.index(cell, strip)];
        if (c.pixels == 0) return {};
        if (has_edge(c)) break;
    }
    if (cell >= grid.cells || cell * cell_rows <= grid.top_row) return {};
    FirstEdge edge;
    edge.upper_m = cell_floor_m(image.camera, cell);
    while (cell + 1 < grid.cells && has_edge(cells[grid.index(cell + 1, strip)])) ++cell;
    edge.lower_m = cell_floor_m(image.camera, cell);
    return edge;
}

/// Foot of a wall whose first edge is known: floor and votes place it better than the edge.
double foot_m(const FirstEdge& edge, const StripEvidence& strip) {
    const double votes_m = strip.votes.score > 0.0 ? strip.votes.forward_m : 0.0;
    if (votes_m >= 0.6 * edge.upper_m && votes_m <= edge.upper_m) return votes_m;
    if (strip.floor_end_m > 0.7 * edge.upper_m) return std::min(strip.floor_end_m, edge.upper_m);
    return edge.lower_m > 0.75 * edge.upper_m ? edge.lower_m : edge.upper_m;
}

}  // namespace

void find_floor_ends(const LevelImage& image, const std::vector<FloorCell>& cells,
                     std::vector<double>& missing, std::vector<StripEvidence>& strips) {
    const StripGrid grid = strip_grid(image);
    missing.assign(static_cast<std::size_t>(grid.cells), 0.0);
    for (int cell = grid.top_row / cell_rows; cell < grid.cells; ++cell)
        missing[static_cast<std::size_t>(cell)] = -std::log(1.0 - presence(grid, cells, cell));
    for (int s = 0; s < grid.strips; ++s)
        strips[static_cast<std::size_t>(s)].floor_end_m = floor_end_m(image, grid, cells, missing, s);
}

void find_walls(const LevelImage& image, const std::vector<FloorCell>& cells, double range_max_m,
                std::vector<StripEvidence>& strips) {
    const StripGrid grid = strip_grid(image);
    const auto at = [&](int s) -> StripEvidence& { return strips[static_cast<std::size_t>(s)]; };
    for (int s = 0; s < grid.strips; ++s) {
        const FirstEdge edge = first_edge(image, grid, cells, s);
        at(s).first_edge_m = edge.upper_m > 0.0 ? foot_m(edge, at(s)) : 0.0;
    }
    for (int s = 0; s < grid.strips; ++s) {
        const double here_m = at(s).first_edge_m;
        int alike = 0;
        for (int k = std::max(0, s - 2); k <= std::min(grid.strips - 1, s + 2); ++k)
            alike += k != s && std::abs(at(k).first_edge_m - here_m) < continuing * std::abs(k - s) * here_m;
        at(s).wall_m = here_m > 0.0 && here_m <= range_max_m && alike >= wall_neighbours ? here_m : 0.0;
    }
}

}  // namespace flownav::obstacles
