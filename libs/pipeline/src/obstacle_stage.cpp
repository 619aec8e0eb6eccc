#include "obstacle_stage.h"

#include "flownav/obstacles/occlusion_check.h"
#include "flownav/obstacles/points.h"
#include "flownav/obstacles/virtual_scan.h"

namespace flownav::pipeline {
namespace {

using Eigen::Vector2d;

constexpr double persisting_share = 0.4;  // of a region's blocks moved in the last cycle as well

double relative_travel_error(const EgoMotion& motion) {
    return motion.sigma_forward_m / std::max(std::abs(motion.forward_m), 1e-6);
}

void count_fate(BlockCounts& counts, BlockLabel label) {
    counts.ground += label == BlockLabel::Ground;
    counts.obstacle += label == BlockLabel::Obstacle;
    counts.eliminated += label == BlockLabel::Eliminated;
    counts.unsupported += label == BlockLabel::Unsupported;
    counts.moving += label == BlockLabel::Moving;
}

}  // namespace

void judge_blocks(State::Impl& s) {
    for (std::size_t i = 0; i < s.layout.size(); ++i) {
        const BlockRecord& block = s.step.blocks[i];
        s.judgements[i] = {};
        s.judgements[i].label = block.label;
        if (block.image_of_cycle == 0) continue;
        const ImageOfCycle& image = s.cycle[block.image_of_cycle - 1];
        s.judgements[i] = obstacles::classify(image.derotation(block.ray), image.judged, s.params.obstacles);
        s.judgements[i].drift /= block.image_of_cycle;
        s.judgements[i].drift_sigma /= block.image_of_cycle;
    }
    obstacles::mark_dynamic_objects(s.judgements, s.layout.neighbours, s.movers);
    obstacles::confirm_by_neighbours(s.judgements, s.layout.neighbours, s.params.obstacles);
    for (std::size_t i = 0; i < s.layout.size(); ++i) {
        s.step.blocks[i].label = s.judgements[i].label;
        s.step.blocks[i].excess_px = s.judgements[i].excess_px;
        count_fate(s.step.counts, s.judgements[i].label);
    }
}

namespace {

/// Where a block of the running cycle is in its last field.
Vector2d now_px(const State::Impl& s, const BlockRecord& block) {
    const double images = static_cast<double>(s.cycle.size()) / block.image_of_cycle;
    return block.vector.at_px + images * block.vector.flow_px;
}

/// True when the region was there in the last cycle as well, and not just a crossing of edges that seemed to
/// move.
bool persists(const State::Impl& s, int region) {
    int blocks = 0;
    int before = 0;
    for (std::size_t i = 0; i < s.layout.size(); ++i) {
        if (s.movers.region_of[i] != region) continue;
        ++blocks;
        before += s.moved_before[i];
    }
    return before >= persisting_share * blocks;
}

/// The lower edge of the region's lowest block in the last field.
Vector2d lowest_px(const State::Impl& s, int region) {
    const Vector2d half_block(0.0, flow::block_px / 2.0);
    Vector2d lowest(0.0, -flow::block_px);
    for (std::size_t i = 0; i < s.layout.size(); ++i) {
        if (s.movers.region_of[i] != region) continue;
        const Vector2d edge_px = now_px(s, s.step.blocks[i]) + half_block;
        if (edge_px.y() > lowest.y()) lowest = edge_px;
    }
    return lowest;
}

/// Points of what moves by itself, at the range of its lowest row.
void publish_movers(State::Impl& s) {
    for (int region = 0; region < s.movers.regions; ++region) {
        const auto contact = obstacles::ground_contact(lowest_px(s, region), s.newest.mapper);
        if (!contact || !persists(s, region)) continue;
        for (std::size_t i = 0; i < s.layout.size(); ++i) {
            if (s.movers.region_of[i] != region) continue;
            const auto point = obstacles::moving_point(now_px(s, s.step.blocks[i]), *contact, s.newest.mapper,
                                                       s.params.obstacles);
            if (point) s.step.obstacles.push_back(*point);
        }
    }
    for (std::size_t i = 0; i < s.layout.size(); ++i) s.moved_before[i] = s.movers.region_of[i] >= 0;
}

}  // namespace

void publish_obstacles(State::Impl& s) {
    const Pose2 T_end_reference = inverse(pose_after(s.cycle.back().motion));
    const CameraMount& mount = s.reference.field.camera.mount;
    Step& out = s.step;
    for (std::size_t i = 0; i < s.layout.size(); ++i) {
        const BlockRecord& block = out.blocks[i];
        if (block.image_of_cycle == 0) continue;
        if (block.label == BlockLabel::Obstacle) {
            const ImageOfCycle& image = s.cycle[block.image_of_cycle - 1];
            const auto point =
                obstacles::obstacle_point(s.judgements[i], block.vector.at_px + block.vector.flow_px,
                                          compose(T_end_reference, image.T_reference_mid), mount,
                                          relative_travel_error(image.motion), s.params.obstacles);
            if (point) out.obstacles.push_back(*point);
        } else if (block.label == BlockLabel::Ground) {
            const auto patch = obstacles::ground_patch(block.vector.at_px, s.reference.mapper,
                                                       T_end_reference, s.params.obstacles.range_max_m);
            if (patch) out.ground.push_back(*patch);
        }
    }
    publish_movers(s);
    obstacles::remove_occluded_floor(out.obstacles, {mount.forward_m, mount.left_m}, out.ground);
    obstacles::fill_scan(out.scan, out.obstacles, out.ground);
}

}  // namespace flownav::pipeline
