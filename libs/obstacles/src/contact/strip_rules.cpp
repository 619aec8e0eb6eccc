#include "flownav/obstacles/strip_rules.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "flownav/math/order_statistic.h"
#include "flownav/obstacles/strip_grid.h"

namespace flownav::obstacles {
namespace {

// Free floor.
constexpr int floor_min = 3;              // pixels of floor in a cell that is floor
constexpr double not_floor_share = 0.34;  // of them: largest number of pixels that are not
constexpr float preference_min = 0.3F;    // of the costs of floor to those of something nearer
constexpr double usual_max = 1.2;         // more texture is not asked for
constexpr double sure_share = 0.6;     // of the usual preference of a row: least of a cell with floor pixels
constexpr double least_share = 0.65;   // of the usual preference of a row: least of a cell
constexpr int preferring_min = 64;     // pixels of a cell and its neighbours that tell a preference
constexpr double misfit_share = 0.1;   // of the pixels of a cell that moves as floor
constexpr double gap_share = 0.2;      // of the distance: longest way without a cell of floor
constexpr double missing_max = 4.0;    // log-likelihood of texture that should have been seen
constexpr double contradiction = 1.5;  // added for a cell that is not floor
constexpr double presence_max = 0.97;
constexpr int presence_cells = 3;  // cells over which the presence of texture is measured
// Where texture ends along a line.
constexpr int end_cells = 4;          // on either side of an end are compared
constexpr int end_pixels_min = 80;    // of each side
constexpr double texture_min = 0.5;   // preference before the end
constexpr double texture_left = 0.2;  // of it behind the end, at the most
constexpr double one_line = 0.12;     // largest relative step of range between the strips of one line
constexpr int line_neighbours = 3;    // of the four nearest strips
constexpr double line_within_m = 1.3;
// Walls.
constexpr int above_horizon_cells = 2;
constexpr double low_floor_share = 0.8;  // of the way to such a surface: floor is confirmed
constexpr double low_missing_min = 0.7;  // so surely do other strips show floor in its row
constexpr double low_surface_m = 1.6;    // of a surface that does not reach above the horizon
constexpr double continuing = 0.2;       // largest relative step of range between strips of one wall
constexpr int wall_neighbours = 2;       // of the four nearest strips

bool has_floor_pixels(const FloorCell& cell) {
    return cell.floor >= floor_min && cell.not_floor <= not_floor_share * cell.floor;
}

/// Preference of a cell, a pixel.
float preference(const FloorCell& cell) {
    return cell.compared > 0 ? cell.preference / static_cast<float>(cell.compared) : 0.0F;
}

/// Median of the preferences of a group of rows: how much texture the floor shows there.
double usual_preference(const StripGrid& grid, const std::vector<FloorCell>& cells, int cell,
                        std::vector<double>& sorted) {
    sorted.clear();
    for (int s = 0; s < grid.strips; ++s)
        if (cells[grid.index(cell, s)].compared > 0) sorted.push_back(preference(cells[grid.index(cell, s)]));
    return sorted.empty() ? 0.0 : nth_smallest(sorted, sorted.size() / 2);
}

/// True when a cell and its neighbours in the strip move as floor, however weak their texture. `least`: for
/// the cell itself.
bool moves_as_floor(const StripGrid& grid, const std::vector<FloorCell>& cells, int cell, int strip,
                    double least) {
    const FloorCell& here = cells[grid.index(cell, strip)];
    float sum = 0.0F;
    int compared = 0;
    for (int c = std::max(0, cell - 1); c <= std::min(grid.cells - 1, cell + 1); ++c) {
        sum += cells[grid.index(c, strip)].preference;
        compared += cells[grid.index(c, strip)].compared;
    }
    return compared >= preferring_min && sum > preference_min * static_cast<float>(compared) &&
           preference(here) > least && here.misfits <= misfit_share * here.compared &&
           here.not_floor <= here.floor;
}

/// Which cells show floor.
void find_floor(const StripGrid& grid, const std::vector<FloorCell>& cells, FloorMap& map) {
    map.floor.assign(grid.size(), 0);
    for (int cell = grid.top_row / cell_rows; cell < grid.cells; ++cell) {
        const double usual = usual_preference(grid, cells, cell, map.sorted);
        const double least = least_share * std::max<double>(usual, preference_min);
        for (int s = 0; s < grid.strips; ++s)
            map.floor[grid.index(cell, s)] =
                (has_floor_pixels(cells[grid.index(cell, s)]) &&
                 preference(cells[grid.index(cell, s)]) > sure_share * std::min(usual, usual_max)) ||
                moves_as_floor(grid, cells, cell, s, least);
    }
}

/// Share of the strips that show floor in this cell or the two nearer ones.
double presence(const StripGrid& grid, const std::vector<FloorCell>& cells, const std::vector<char>& floor,
                int cell) {
    int live = 0;
    int with_floor = 0;
    for (int s = 0; s < grid.strips; ++s) {
        bool in_view = false;
        bool seen = false;
        for (int c = cell; c < std::min(cell + presence_cells, grid.cells); ++c) {
            in_view |= cells[grid.index(c, s)].compared > 0;
            seen |= floor[grid.index(c, s)] != 0;
        }
        live += in_view;
        with_floor += seen;
    }
    return live > 0 ? std::min(static_cast<double>(with_floor) / live, presence_max) : 0.0;
}

FloorEnd floor_end(const LevelImage& image, const StripGrid& grid, const std::vector<FloorCell>& cells,
                   const FloorMap& map, int strip) {
    const int top = grid.top_row / cell_rows + 1;
    FloorEnd end;
    double reached_m = image.camera.floor_m(grid.cells * cell_rows - 1);  // lower border of the view
    double lacking = 0.0;
    for (int cell = grid.cells - 1; cell >= top; --cell) {
        const FloorCell& c = cells[grid.index(cell, strip)];
        const double far_m = image.camera.floor_m(cell * cell_rows);
        if (map.floor[grid.index(cell, strip)] != 0) {
            end = {far_m, cell, false};
            reached_m = far_m;
            lacking = 0.0;
            continue;
        }
        if (c.compared > 0) lacking += map.missing[static_cast<std::size_t>(cell)];
        if (c.not_floor >= floor_min && c.not_floor > c.floor) lacking += contradiction;
        if (lacking > missing_max || far_m - reached_m > gap_share * std::max(1.0, far_m)) break;
    }
    return end;
}

/// Mean preference of the cells begin to end - 1 of a strip; empty where too few pixels tell.
std::optional<double> mean_preference(const StripGrid& grid, const std::vector<FloorCell>& cells, int strip,
                                      int begin, int end) {
    double sum = 0.0;
    int compared = 0;
    for (int cell = std::max(0, begin); cell < std::min(end, grid.cells); ++cell) {
        sum += cells[grid.index(cell, strip)].preference;
        compared += cells[grid.index(cell, strip)].compared;
    }
    return compared >= end_pixels_min ? std::optional<double>(sum / compared) : std::nullopt;
}

/// True when the floor of a strip has texture up to its end, and what lies behind has none.
bool texture_ends(const StripGrid& grid, const std::vector<FloorCell>& cells, int strip,
                  const FloorEnd& end) {
    if (!(end.forward_m > 0.0 && end.forward_m < line_within_m)) return false;
    const auto before = mean_preference(grid, cells, strip, end.cell, end.cell + end_cells);
    const auto behind = mean_preference(grid, cells, strip, end.cell - end_cells, end.cell);
    return before && behind && *before > texture_min && *behind < texture_left * *before;
}

/// How many of the four nearest strips have nearly the same range; `range_m(strip)`, 0: none. `share`:
/// largest step of the range to the next strip.
template <class Range>
int alike_beside(const StripGrid& grid, int strip, double share, const Range& range_m) {
    const double here_m = range_m(strip);
    int alike = 0;
    for (int k = std::max(0, strip - 2); k <= std::min(grid.strips - 1, strip + 2); ++k)
        alike += k != strip && std::abs(range_m(k) - here_m) < share * std::abs(k - strip) * here_m;
    return alike;
}

/// Marks strips as seen where texture ends along a line: what begins there is something else than this floor,
/// though it shows no edge.
void see_ends_of_texture(const StripGrid& grid, const std::vector<FloorEnd>& ends,
                         std::vector<StripEvidence>& strips) {
    const auto end_m = [&](int s) {
        const FloorEnd& end = ends[static_cast<std::size_t>(s)];
        return end.of_texture ? end.forward_m : 0.0;
    };
    for (int s = 0; s < grid.strips; ++s)
        if (end_m(s) > 0.0 && alike_beside(grid, s, one_line, end_m) >= line_neighbours)
            strips[static_cast<std::size_t>(s)].is_seen = true;
}

/// The first edge below a surface that has none.
struct FirstEdge {
    int cell = 0;          ///< its uppermost one
    double upper_m = 0.0;  ///< distance; 0: no such surface
    double lower_m = 0.0;  ///< lower rim of the edge
};

/// Looks down a strip from cell `from`.
FirstEdge first_edge(const LevelImage& image, const StripGrid& grid, const std::vector<FloorCell>& cells,
                     int strip, int from) {
    if (from < 1) return {};
    int cell = from;
    for (; cell < grid.cells; ++cell) {
        const FloorCell& c = cells[grid.index(cell, strip)];
        if (c.pixels == 0) return {};
        if (has_edge(c)) break;
    }
    if (cell >= grid.cells || cell * cell_rows <= grid.top_row) return {};
    const int upper = cell;
    while (cell + 1 < grid.cells && has_edge(cells[grid.index(cell + 1, strip)])) ++cell;
    return {upper, cell_floor_m(image.camera, upper), cell_floor_m(image.camera, cell)};
}

/// The surface reaches above the horizon; or it is near, begins where the floor ends, and reaches to where
/// floor would be floor_max_m away, as things a little lower than the camera do.
FirstEdge surface_edge(const LevelImage& image, const StripGrid& grid, const std::vector<FloorCell>& cells,
                       const FloorMap& map, int strip, double floor_end_m) {
    const FirstEdge tall =
        first_edge(image, grid, cells, strip, grid.horizon_row / cell_rows - above_horizon_cells);
    if (tall.upper_m > 0.0) return tall;
    const FirstEdge low = first_edge(image, grid, cells, strip, grid.top_row / cell_rows + 1);
    if (!(low.upper_m > 0.0 && low.upper_m < low_surface_m)) return {};
    const auto edge = map.missing.begin() + low.cell;
    const double missing = std::accumulate(map.missing.begin(), edge, 0.0);
    const bool hides_floor = edge[0] > low_missing_min && missing > missing_max;
    return hides_floor && floor_end_m > low_floor_share * low.upper_m ? low : FirstEdge{};
}

/// Foot of a wall whose first edge is known: floor and votes place it better than the edge.
double foot_m(const FirstEdge& edge, const StripEvidence& strip) {
    const double votes_m = strip.votes.score > 0.0 ? strip.votes.forward_m : 0.0;
    if (votes_m >= 0.6 * edge.upper_m && votes_m <= edge.upper_m) return votes_m;
    if (strip.floor_end_m > 0.7 * edge.upper_m) return std::min(strip.floor_end_m, edge.upper_m);
    return edge.lower_m > 0.75 * edge.upper_m ? edge.lower_m : edge.upper_m;
}

}  // namespace

void find_floor_ends(const LevelImage& image, const std::vector<FloorCell>& cells, FloorMap& map,
                     std::vector<StripEvidence>& strips) {
    const StripGrid grid = strip_grid(image);
    find_floor(grid, cells, map);
    map.missing.assign(static_cast<std::size_t>(grid.cells), 0.0);
    for (int cell = grid.top_row / cell_rows; cell < grid.cells; ++cell)
        map.missing[static_cast<std::size_t>(cell)] = -std::log(1.0 - presence(grid, cells, map.floor, cell));
    map.ends.clear();
    for (int s = 0; s < grid.strips; ++s) {
        FloorEnd end = floor_end(image, grid, cells, map, s);
        end.of_texture = texture_ends(grid, cells, s, end);
        map.ends.push_back(end);
        strips[static_cast<std::size_t>(s)].floor_end_m = end.forward_m;
    }
    see_ends_of_texture(grid, map.ends, strips);
}

void find_walls(const LevelImage& image, const std::vector<FloorCell>& cells, const FloorMap& map,
                double range_max_m, std::vector<StripEvidence>& strips) {
    const StripGrid grid = strip_grid(image);
    const auto at = [&](int s) -> StripEvidence& { return strips[static_cast<std::size_t>(s)]; };
    for (int s = 0; s < grid.strips; ++s) {
        const FirstEdge edge = surface_edge(image, grid, cells, map, s, at(s).floor_end_m);
        at(s).first_edge_m = edge.upper_m > 0.0 ? foot_m(edge, at(s)) : 0.0;
    }
    for (int s = 0; s < grid.strips; ++s) {
        const double here_m = at(s).first_edge_m;
        const int alike = alike_beside(grid, s, continuing, [&](int k) { return at(k).first_edge_m; });
        at(s).wall_m = here_m > 0.0 && here_m <= range_max_m && alike >= wall_neighbours ? here_m : 0.0;
    }
}

}  // namespace flownav::obstacles
