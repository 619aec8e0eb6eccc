#include "block_score.h"

#include "flownav/motion/ray_flow.h"
#include "flownav/obstacles/classify.h"
#include "flownav/testing/truth.h"

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;

constexpr double sure_px = 0.5;

/// Left side of (13) for an exact vector between the reference and the last image of the cycle.
double true_excess_px(const Moment& m, const Vector2d& at_px, const Vector2d& flow_px) {
    const testing::Scene& scene = m.drive.scene;
    const CameraModel reference = testing::nominal_view(scene, m.reference).camera;
    const CameraModel newer = testing::nominal_view(scene, m.image).camera;
    FlowVector vector;
    vector.at_px = at_px;
    vector.flow_px = flow_px;
    const RayFlow ray = motion::ray_flow(vector, RayMapper(reference), RayMapper(newer), Geometry::MidPoint);
    const EgoMotion motion =
        testing::exact_motion(testing::true_view(scene, m.reference), testing::true_view(scene, m.image));
    const Derotation derotated(PlaneGeometry(reference.mount), motion.omega_rad, motion.pitch_rad,
                               Geometry::MidPoint);
    return obstacles::classify(derotated(ray), {reference, motion, 1.0}, m.config.pipeline.obstacles)
        .excess_px;
}

/// True when a block and its surroundings show only ground.
bool only_ground(const Moment& m, const Vector2d& at_px) {
    const sim::View view = testing::true_view(m.drive.scene, m.reference);
    for (int dv = -10; dv <= 10; dv += 4) {
        for (int du = -10; du <= 10; du += 4) {
            const auto sight = testing::look(m.drive.scene.world, view, at_px + Vector2d(du, dv));
            if (!sight || sight->solid != sim::floor_index) return false;
        }
    }
    return true;
}

std::size_t range_index(double range_m) {
    std::size_t i = 0;
    while (i + 1 < range_ends_m.size() && range_m >= range_ends_m.at(i)) ++i;
    return i;
}

}  // namespace

void BlockScore::add(const BlockScore& other) {
    detected.add(other.detected);
    detected_textured.add(other.detected_textured);
    for (const auto& [label, count] : other.labels) labels[label] += count;
    for (const auto& [label, count] : other.fates_textured) fates_textured[label] += count;
    false_blocks.add(other.false_blocks);
    for (const auto& [kind, shares] : other.by_kind)
        for (std::size_t i = 0; i < shares.size(); ++i) by_kind[kind].at(i).add(shares.at(i));
}

void BlockWatcher::see(const Moment& m) {
    if (!m.step.end_of_cycle || m.image <= settling_images) return;
    ++score_.false_blocks.all;
    for (const pipeline::BlockRecord& block : m.step.blocks) see_block(m, block);
}

void BlockWatcher::see_block(const Moment& m, const pipeline::BlockRecord& block) {
    const testing::Scene& scene = m.drive.scene;
    const Vector2d& at_px = block.vector.at_px;
    const bool obstacle = block.label == BlockLabel::Obstacle;
    const auto truth = testing::exact_flow(scene.world, testing::true_view(scene, m.reference),
                                           testing::true_view(scene, m.image), at_px);
    if (!truth || truth->sight.solid == sim::floor_index) {
        if (obstacle && only_ground(m, at_px)) ++score_.false_blocks.hits;
        return;
    }
    const auto& thing = scene.world.solids[static_cast<std::size_t>(truth->sight.solid)];
    if (!truth->inside || truth->occluded || !thing.script.empty()) return;
    if (true_excess_px(m, at_px, truth->flow_px) <= m.config.pipeline.obstacles.tau_px + sure_px) return;
    const Pose2& robot = scene.poses[static_cast<std::size_t>(m.image)];
    const double range_m = (truth->sight.point_m.head<2>() - Vector2d(robot.x_m, robot.y_m)).norm();
    score_.detected.add(obstacle);
    ++score_.labels[block.label];
    if (thing.look.surface == sim::Surface::Patterned) {
        score_.detected_textured.add(obstacle);
        ++score_.fates_textured[block.label];
    }
    score_.by_kind[thing.kind].at(range_index(range_m)).add(obstacle);
}

}  // namespace flownav::fidelity
