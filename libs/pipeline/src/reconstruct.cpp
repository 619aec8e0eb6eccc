#include "reconstruct.h"

#include <algorithm>
#include <cmath>

#include "flownav/flow/kernel.h"
#include "flownav/obstacles/occlusion_check.h"
#include "flownav/obstacles/points.h"
#include "flownav/obstacles/virtual_scan.h"

namespace flownav::pipeline {
namespace {

using Eigen::Vector2d;

constexpr double persisting_share = 0.4;  // of a region's blocks were dynamic in the last cycle as well

double relative_travel_error(const EgoMotion& motion) {
    return motion.sigma_forward_m / std::max(std::abs(motion.forward_m), 1e-6);
}

/// Pixel of a block of the running cycle in its last field.
Vector2d now_px(const Cycle& images, const BlockRecord& block) {
    const double steps = static_cast<double>(images.size()) / block.image_of_cycle;
    return block.vector.at_px + steps * block.vector.flow_px;
}

/// True when the region was dynamic in the last cycle as well. Crossings of edges at rest seem to move in
/// single cycles.
bool persists(const BlockClasses& classes, int region) {
    int blocks = 0;
    int before = 0;
    for (std::size_t i = 0; i < classes.of_block.size(); ++i) {
        if (classes.dynamic.region_of[i] != region) continue;
        ++blocks;
        before += classes.moved_before[i];
    }
    return before >= persisting_share * blocks;
}

/// The lower edge of the region's lowest block in the last field, pixels.
Vector2d lowest_px(const EndedCycle& cycle, int region) {
    const Vector2d half_block(0.0, flow::block_px / 2.0);
    Vector2d lowest(0.0, -flow::block_px);
    for (std::size_t i = 0; i < cycle.blocks.size(); ++i) {
        if (cycle.classes.dynamic.region_of[i] != region) continue;
        const Vector2d edge_px = now_px(cycle.images, cycle.blocks[i]) + half_block;
        if (edge_px.y() > lowest.y()) lowest = edge_px;
    }
    return lowest;
}

/// Adds the points of dynamic objects, each region at the range of its lowest row.
void add_dynamic_objects(const EndedCycle& cycle, const obstacles::ObstacleParams& params,
                         std::vector<ObstaclePoint>& points) {
    for (int region = 0; region < cycle.classes.dynamic.regions; ++region) {
        const auto contact = obstacles::ground_contact(lowest_px(cycle, region), cycle.newest.mapper);
        if (!contact || !persists(cycle.classes, region)) continue;
        for (std::size_t i = 0; i < cycle.blocks.size(); ++i) {
            if (cycle.classes.dynamic.region_of[i] != region) continue;
            const auto point = obstacles::moving_point(now_px(cycle.images, cycle.blocks[i]), *contact,
                                                       cycle.newest.mapper, params);
            if (point) points.push_back(*point);
        }
    }
}

/// Adds the points of obstacles at rest, and the floor.
void add_static_scene(const EndedCycle& cycle, const obstacles::ObstacleParams& params, Reconstruction& out) {
    const Pose2 T_end_reference = inverse(pose_after(cycle.images.back().motion));
    const CameraMount& mount = cycle.reference.field.camera.mount;
    for (std::size_t i = 0; i < cycle.blocks.size(); ++i) {
        const BlockRecord& block = cycle.blocks[i];
        const obstacles::Classification& c = cycle.classes.of_block[i];
        if (block.image_of_cycle == 0) continue;
        if (c.label == BlockLabel::Obstacle) {
            const ImageOfCycle& image = cycle.images[block.image_of_cycle - 1];
            const auto point = obstacles::obstacle_point(c, block.vector.at_px + block.vector.flow_px,
                                                         compose(T_end_reference, image.T_reference_mid),
                                                         mount, relative_travel_error(image.motion), params);
            if (point) out.obstacles.push_back(*point);
        } else if (c.label == BlockLabel::Ground) {
            const auto patch = obstacles::ground_patch(block.vector.at_px, cycle.reference.mapper,
                                                       T_end_reference, params.range_max_m);
            if (patch) out.ground.push_back(*patch);
        }
    }
}

}  // namespace

void reconstruct(const EndedCycle& cycle, const obstacles::ObstacleParams& params, Reconstruction& out) {
    out.obstacles.clear();
    out.ground.clear();
    add_static_scene(cycle, params, out);
    add_dynamic_objects(cycle, params, out.obstacles);
    const CameraMount& mount = cycle.reference.field.camera.mount;
    obstacles::remove_occluded_floor(out.obstacles, {mount.forward_m, mount.left_m}, out.ground);
    obstacles::remove_floor_behind_contacts(cycle.contacts, {mount.forward_m, mount.left_m}, out.ground);
    obstacles::fill_scan(out.scan, out.obstacles, out.ground);
    obstacles::add_contacts(out.scan, cycle.contacts);
}

}  // namespace flownav::pipeline
