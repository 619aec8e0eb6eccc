#include "map_score.h"

#include "flownav/replay/obstacle_set.h"
#include "flownav/testing/truth.h"

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;

constexpr double occupied_from = 0.65;
constexpr double surface_cell_m = 0.1;
constexpr double seen_to_m = 4.0;
constexpr double precise_m = 0.2;
constexpr double found_m = 0.15;

std::vector<Vector2d> occupied_cells(const mrpt::maps::COccupancyGridMap2D& grid) {
    std::vector<Vector2d> cells;
    for (int y = 0; y < static_cast<int>(grid.getSizeY()); ++y) {
        for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x) {
            if (1.0 - grid.getCell(x, y) > occupied_from) cells.emplace_back(grid.idx2x(x), grid.idx2y(y));
        }
    }
    return cells;
}

int cell_of(double metres) {
    return static_cast<int>(std::floor(metres / surface_cell_m));
}

}  // namespace

void MapScore::add(const MapScore& other) {
    precise.add(other.precise);
    found.add(other.found);
}

void MapWatcher::see(const Moment& m) {
    if (replay::is_new_for_map(m.step)) {
        replay::copy_surroundings(m.step, set_);
        map_.insert(set_);
    }
    if (!m.step.end_of_cycle) return;
    const testing::Scene& scene = m.drive.scene;
    const sim::View view = testing::true_view(scene, m.reference);
    for (const pipeline::BlockRecord& block : m.step.blocks) {
        const auto sight = testing::look(scene.world, view, block.vector.at_px);
        if (!sight || sight->solid == sim::floor_index || sight->depth_m > seen_to_m) continue;
        const auto& thing = scene.world.solids[static_cast<std::size_t>(sight->solid)];
        if (!thing.script.empty()) continue;
        seen_.insert({cell_of(sight->point_m.x()), cell_of(sight->point_m.y())});
    }
}

MapScore MapWatcher::result(const sim::World& world) const {
    MapScore score;
    const std::vector<Vector2d> occupied = occupied_cells(map_.grid());
    for (const Vector2d& at_m : occupied) {
        score.precise.add(std::any_of(world.solids.begin(), world.solids.end(), [&](const sim::Solid& p) {
            return testing::distance_m(p, at_m) < precise_m;
        }));
    }
    for (const auto& [x, y] : seen_) {
        const Vector2d at_m((x + 0.5) * surface_cell_m, (y + 0.5) * surface_cell_m);
        score.found.add(std::any_of(occupied.begin(), occupied.end(),
                                    [&](const Vector2d& o) { return (o - at_m).norm() < found_m; }));
    }
    return score;
}

}  // namespace flownav::fidelity
