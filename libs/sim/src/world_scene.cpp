#include "world_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "flownav/sim/plan_view.h"
#include "flownav/sim/random.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double fine_m = 0.0002;         ///< deviation of round things seen from nearby
constexpr double coarse_m = 0.0006;       ///< and from farther than coarse_from_m
constexpr double coarse_from_m = 2.5;     ///< where that is a tenth of a pixel
constexpr double floor_beyond_m = 150.0;  ///< of the outermost thing
constexpr double lid_below_m = 0.001;     ///< pieces of ground that reach lower take the place of the floor
constexpr double light_lid_m = 0.003;     ///< height of lids above the light on the floor

/// Where a solid's piece of its tile begins: things of one surface share a tile and differ in that.
Vector2d offset_m(const Look& look, double tile_m) {
    Random random(look.seed);
    const double u = random.uniform(0.0, tile_m);
    return {u, random.uniform(0.0, tile_m)};
}

void put(MeshVertex& vertex, const Eigen::Isometry3d& T) {
    const Eigen::Vector3f at = (T * Vector3d(vertex.x, vertex.y, vertex.z)).cast<float>();
    vertex.x = at.x();
    vertex.y = at.y();
    vertex.z = at.z();
}

/// In units of the tile, from metres.
void fit(MeshVertex& vertex, const Vector2d& offset, double tile_m) {
    vertex.u = static_cast<float>((vertex.u + offset.x()) / tile_m);
    vertex.v = static_cast<float>((vertex.v + offset.y()) / tile_m);
}

}  // namespace

WorldScene::WorldScene(const World& world) {
    add_floor(world);
    for (const Solid& solid : world.solids)
        if (solid.visible) add_solid(solid);
    add_ground(world);
}

std::size_t WorldScene::texture_of(const Look& look, const TileGrid& grid) {
    const std::array<int, 3> key{static_cast<int>(look.surface), static_cast<int>(std::lround(look.grey)),
                                 grid.size_px};
    const auto known = tile_of_.find(key);
    if (known != tile_of_.end()) return known->second;
    const Look shared{look.surface, static_cast<double>(key[1]), 1};
    tiles_.push_back(texture_tile(shared, grid));
    return tile_of_[key] = tiles_.size() - 1;
}

void WorldScene::add_floor(const World& world) {
    Vector2d low = world.start.x_m * Vector2d::UnitX() + world.start.y_m * Vector2d::UnitY();
    Vector2d high = low;
    for (const Solid& solid : world.solids) {
        low = low.cwiseMin(solid.T_world_solid.translation().head<2>());
        high = high.cwiseMax(solid.T_world_solid.translation().head<2>());
    }
    const Vector2d middle = (low + high) / 2;
    const double half_m = (high - low).maxCoeff() / 2 + floor_beyond_m;
    Part part;
    part.texture = texture_of(world.floor, floor_grid);
    const double tile_m = tiles_[part.texture].size_m;
    const Vector2d offset = offset_m(world.floor, tile_m);
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        const Vector2d at = middle + half_m * Vector2d(x, y);
        MeshVertex vertex{static_cast<float>(at.x()), static_cast<float>(at.y()), 0.0F,
                          static_cast<float>(at.x()), static_cast<float>(at.y())};
        fit(vertex, offset, tile_m);
        vertices_.push_back(vertex);
    }
    indices_ = {0, 1, 2, 0, 2, 3};
    part.indices = {6, 6};
    parts_.push_back(std::move(part));
}

void WorldScene::add_solid(const Solid& solid) {
    Part part;
    part.solid = solid;
    part.radius_m = bounding_radius_m(solid.shape);
    part.texture = texture_of(solid.look, thing_grid);
    part.first_vertex = vertices_.size();
    const double tile_m = tiles_[part.texture].size_m;
    const Vector2d offset = offset_m(solid.look, tile_m);
    for (const int detail : {0, 1}) {
        Mesh mesh = mesh_of(solid.shape, detail == 0 ? fine_m : coarse_m);
        const auto first = static_cast<std::uint32_t>(vertices_.size() + part.own_vertices.size());
        part.first_index[detail] = indices_.size();
        part.indices[detail] = static_cast<int>(mesh.indices.size());
        for (const std::uint32_t index : mesh.indices) indices_.push_back(first + index);
        for (MeshVertex& vertex : mesh.vertices) {
            fit(vertex, offset, tile_m);
            part.own_vertices.push_back(vertex);
        }
    }
    vertices_.insert(vertices_.end(), part.own_vertices.begin(), part.own_vertices.end());
    place(part, 0.0);
    if (part.solid.script.empty()) part.own_vertices.clear();
    parts_.push_back(std::move(part));
}

void WorldScene::add_quad(const std::array<Vector3d, 4>& corners_m, const std::array<Vector2d, 4>& uv_m,
                          const Look& look) {
    Part part;
    const Vector3d middle = (corners_m[0] + corners_m[1] + corners_m[2] + corners_m[3]) / 4.0;
    part.solid.T_world_solid.translation() = middle;
    for (const Vector3d& corner : corners_m)
        part.radius_m = std::max(part.radius_m, (corner - middle).norm());
    part.texture = texture_of(look, floor_grid);
    part.first_vertex = vertices_.size();
    part.first_index = {indices_.size(), indices_.size()};
    part.indices = {6, 6};
    const double tile_m = tiles_[part.texture].size_m;
    const Vector2d offset = offset_m(look, tile_m);
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector3f p = corners_m[i].cast<float>();
        const Eigen::Vector2f t = uv_m[i].cast<float>();
        MeshVertex vertex{p.x(), p.y(), p.z(), t.x(), t.y()};
        fit(vertex, offset, tile_m);
        vertices_.push_back(vertex);
    }
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) indices_.push_back(first + i);
    parts_.push_back(std::move(part));
}

void WorldScene::add_ground(const World& world) {
    for (const GroundPiece& piece : world.ground) {
        const Vector2d half = piece.size_m / 2;
        const std::array<Vector2d, 4> uv = {-half, Vector2d(half.x(), -half.y()), half,
                                            Vector2d(-half.x(), half.y())};
        std::array<Vector3d, 4> corners;
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] = piece.T_world_ground * Vector3d(uv[i].x(), uv[i].y(), 0.0);
        add_quad(corners, uv, piece.look);
    }
    for (const GroundWall& wall : ground_walls(world)) {
        const double length_m = (wall.right_m - wall.left_m).norm();
        add_quad({wall.left_m, wall.right_m, wall.right_m + wall.right_rise_m * Vector3d::UnitZ(),
                  wall.left_m + wall.left_rise_m * Vector3d::UnitZ()},
                 {Vector2d(0.0, 0.0), Vector2d(length_m, 0.0), Vector2d(length_m, wall.right_rise_m),
                  Vector2d(0.0, wall.left_rise_m)},
                 wall_look(world.ground[static_cast<std::size_t>(wall.piece)]));
    }
    lids_ = make_lids(world, 0.0);
    light_lids_ = make_lids(world, light_lid_m);
}

/// Over the pieces of ground that reach down to the floor or below.
WorldScene::Lids WorldScene::make_lids(const World& world, double height_m) {
    Lids lids;
    lids.first_index = indices_.size();
    for (const GroundPiece& piece : world.ground) {
        const Vector2d half = piece.size_m / 2;
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        bool reaches_floor = false;
        for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            const Eigen::Vector3d corner = piece.T_world_ground * Vector3d(x * half.x(), y * half.y(), 0.0);
            reaches_floor = reaches_floor || corner.z() < lid_below_m;
            vertices_.push_back({static_cast<float>(corner.x()), static_cast<float>(corner.y()),
                                 static_cast<float>(height_m), 0.0F, 0.0F});
        }
        if (!reaches_floor) continue;
        for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) indices_.push_back(first + i);
        lids.indices += 6;
    }
    return lids;
}

void WorldScene::place(Part& part, double time_s) {
    const Eigen::Isometry3d T_world_solid = pose_at(part.solid, time_s);
    for (std::size_t i = 0; i < part.own_vertices.size(); ++i) {
        MeshVertex& vertex = vertices_[part.first_vertex + i];
        vertex = part.own_vertices[i];
        put(vertex, T_world_solid);
    }
    part.solid.T_world_solid = T_world_solid;
}

void WorldScene::look(const ViewPyramid& view, FloorLight light, double time_s) {
    light_ = std::move(light);
    drawn_.clear();
    for (std::size_t i = 1; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        if (!part.own_vertices.empty()) place(part, time_s);
        const Vector3d from_eye = part.solid.T_world_solid.translation() - view.eye_m;
        const bool out = std::any_of(view.inward.begin(), view.inward.end(), [&](const Vector3d& inward) {
            return inward.dot(from_eye) < -part.radius_m;
        });
        if (out) continue;
        const double distance_m = from_eye.norm();
        drawn_.push_back({distance_m, i, distance_m > coarse_from_m ? 1 : 0});
    }
    std::sort(drawn_.begin(), drawn_.end(), [](const Drawn& a, const Drawn& b) {
        return std::pair(a.distance_m, a.part) < std::pair(b.distance_m, b.part);
    });
    drawn_.push_back({0.0, 0, 0});  // the floor, behind whatever stands on it
}

mrpt::math::TBoundingBoxf WorldScene::internalBoundingBoxLocal() const {
    constexpr float far = 1e4F;
    return {{-far, -far, -far}, {far, far, far}};
}

}  // namespace flownav::sim
