#include "ego_score.h"

#include "flownav/math/units.h"
#include "flownav/testing/truth.h"

namespace flownav::fidelity {
namespace {

constexpr double slowest_compared_mps = 0.05;
constexpr double covered_from = 0.5;

/// Motion of the robot and of the camera's pitch since the previous image.
EgoMotion true_motion(const Moment& m) {
    return testing::exact_motion(testing::true_view(m.drive.scene, m.image - 1),
                                 testing::true_view(m.drive.scene, m.image));
}

bool has_mover(const sim::World& world) {
    return !world.solids.empty() && world.solids.back().kind == sim::ThingKind::Mover;
}

}  // namespace

double covered_by_movers(const Moment& m) {
    const sim::World& world = m.drive.scene.world;
    if (!has_mover(world)) return 0.0;
    const sim::View view = testing::true_view(m.drive.scene, m.reference);
    Share moving;
    for (const pipeline::BlockRecord& block : m.step.blocks) {
        const auto sight = testing::look(world, view, block.vector.at_px);
        moving.add(sight && sight->solid >= 0 &&
                   world.solids[static_cast<std::size_t>(sight->solid)].kind == sim::ThingKind::Mover);
    }
    return moving.all > 0 ? moving.rate() : 0.0;
}

void EgoScore::add(const EgoScore& other) {
    ok.add(other.ok);
    omega_degps.add(other.omega_degps);
    cycle_degps.add(other.cycle_degps);
    pitch_degps.add(other.pitch_degps);
    v_percent.add(other.v_percent);
    v_measured.add(other.v_measured);
    end_percent.add(other.end_percent);
    heading_deg.add(other.heading_deg);
    covered_degps.add(other.covered_degps);
    covered_most = std::max(covered_most, other.covered_most);
    path_m += other.path_m;
}

void EgoWatcher::see(const Moment& m) {
    const Pose2& truth = m.drive.scene.poses[static_cast<std::size_t>(m.image)];
    if (m.image == 0) first_flow_ = m.step.T_start_robot;
    if (m.image == 0) first_truth_ = truth;
    if (m.image > 0) score_.path_m += std::hypot(truth.x_m - last_truth_.x_m, truth.y_m - last_truth_.y_m);
    last_flow_ = m.step.T_start_robot;
    last_truth_ = truth;
    const bool ok = m.step.status == FieldStatus::Ok;
    score_.ok.add(ok);
    if (m.step.image_of_cycle == 1) covered_ = covered_by_movers(m);
    score_.covered_most = std::max(score_.covered_most, covered_);
    if (m.image > settling_images && ok) {
        see_omega(m);
        see_speed(m);
    }
    if (m.step.end_of_cycle || !ok) finish_cycle();
}

void EgoWatcher::see_omega(const Moment& m) {
    const double rate_hz = m.drive.scene.options.rate_hz;
    const EgoMotion truth = true_motion(m);
    const double error_degps = deg(m.step.omega_radps - truth.omega_rad * rate_hz);
    score_.omega_degps.add(error_degps);
    score_.pitch_degps.add(deg(m.step.pitch_rate_radps - truth.pitch_rad * rate_hz));
    if (covered_ >= covered_from) score_.covered_degps.add(error_degps);
    cycle_.add(error_degps);
}

void EgoWatcher::see_speed(const Moment& m) {
    if (m.step.end_of_cycle) score_.v_measured.add(m.step.v_measured);
    if (!m.step.v_measured) return;
    const double truth_mps = true_motion(m).forward_m * m.drive.scene.options.rate_hz;
    if (truth_mps > slowest_compared_mps) score_.v_percent.add(100.0 * (m.step.v_mps / truth_mps - 1.0));
}

void EgoWatcher::finish_cycle() {
    if (cycle_.count > 0) score_.cycle_degps.add(cycle_.mean());
    cycle_ = {};
}

EgoScore EgoWatcher::result() const {
    EgoScore score = score_;
    const Pose2 flow = compose(inverse(first_flow_), last_flow_);
    const Pose2 truth = compose(inverse(first_truth_), last_truth_);
    score.heading_deg.add(deg(wrap_angle(flow.yaw_rad - truth.yaw_rad)));
    if (score.path_m > 0.0)
        score.end_percent.add(100.0 * std::hypot(flow.x_m - truth.x_m, flow.y_m - truth.y_m) / score.path_m);
    return score;
}

}  // namespace flownav::fidelity
