#include "flow_field_samples.h"

#include <gtest/gtest.h>

namespace flownav::testing {
namespace {

constexpr double start_s = 1767225600.125;

/// Generates 0.1, 0.2, ..., so that all numbers differ.
class Numbers {
  public:
    double operator()() { return 0.1 * ++count_; }
    Eigen::Vector2d pair() {
        const double x = (*this)();
        return {x, -(*this)()};
    }

  private:
    int count_ = 0;
};

pipeline::BlockRecord block(Numbers& next, int i) {
    pipeline::BlockRecord b;
    b.vector.at_px = next.pair();
    b.vector.flow_px = next.pair();
    b.vector.sigma_px = next.pair();
    b.vector.confidence = next();
    b.vector.valid = i % 2 == 0;
    b.predicted_px = next.pair();
    b.ray.at = next.pair();
    b.ray.flow = next.pair();
    b.ray.sigma = next.pair();
    b.image_of_cycle = i;
    b.in_ground_window = i % 3 == 0;
    b.fresh = i % 4 == 0;
    b.omega_rad = next();
    b.excess_px = next();
    return b;
}

ContactStrip strip(Numbers& next, BeamKind kind, BeamCause cause) {
    return {kind, cause, next(), next(), next(), next(), next(), kind != BeamKind::Unknown};
}

/// A strip of every kind and cause.
ContactScan contacts(Numbers& next) {
    ContactScan scan;
    scan.gate = ContactGate::PoorFloor;
    scan.first = -3;
    scan.step = next();
    scan.camera_m = next.pair();
    scan.T_robot_scan = {next(), next(), next()};
    scan.floor = {next(), next(), next(), next(), next(), next(), next(), next()};
    scan.strips = {strip(next, BeamKind::Unknown, BeamCause::None),
                   strip(next, BeamKind::Free, BeamCause::None)};
    for (const BeamCause cause : {BeamCause::Votes, BeamCause::Wall, BeamCause::Drop, BeamCause::Blocks})
        scan.strips.push_back(strip(next, BeamKind::Obstacle, cause));
    return scan;
}

CameraModel camera() {
    CameraModel c{768, 288, 737.6, 368.8, 383.5, 143.25, {0.1, -0.05, 0.001, 0.002, 0.01}, {}};
    c.mount = {0.9, 0.4363, 0.02, -0.03, 0.1, 0.05};
    return c;
}

pipeline::Step finished_cycle() {
    Numbers next;
    pipeline::Step s;
    s.timestamp_s = start_s + 0.16;
    s.status = FieldStatus::Ok;
    s.restarted = true;
    s.image_of_cycle = 4;
    s.cycle_images = 5;
    s.end_of_cycle = true;
    s.omega_radps = next();
    s.pitch_rate_radps = -next();
    s.v_mps = next();
    s.v_measured = true;
    s.pitch_correction_rad = next();
    s.motion = {next(), next(), next(), next(), next(), next(), true, false, 300, 20};
    s.motion.omega_source = MotionSource::Gyro;
    s.T_start_robot = {next(), next(), next()};
    s.counts = {350, 320, 301, 21, 200, 15, 7, 3, 2};
    for (const BlockLabel label :
         {BlockLabel::Unplaced, BlockLabel::Sifted, BlockLabel::Eliminated, BlockLabel::Ground,
          BlockLabel::Obstacle, BlockLabel::Moving, BlockLabel::Unsupported, BlockLabel::Unjudged}) {
        s.blocks.push_back(block(next, static_cast<int>(s.blocks.size())));
        s.blocks.back().label = label;
    }
    s.obstacles = {{{next(), next(), next()}, next(), next.pair(), false},
                   {{next(), next(), next()}, next(), next.pair(), true}};
    s.ground = {{next.pair(), next.pair(), 0.125}};
    s.scan = {-0.2, 0.2, {{BeamKind::Unknown, 0.0}, {BeamKind::Free, next()}, {BeamKind::Obstacle, next()}}};
    for (const BeamCause cause : {BeamCause::Blocks, BeamCause::Votes, BeamCause::Wall, BeamCause::Drop})
        s.scan.beams.push_back({BeamKind::Obstacle, next(), cause, next(), next()});
    s.new_contacts = true;
    s.contacts = contacts(next);
    return s;
}

void expect_equal(const CameraModel& a, const CameraModel& b) {
    EXPECT_EQ(a.width_px, b.width_px);
    EXPECT_EQ(a.height_px, b.height_px);
    EXPECT_EQ(a.fx_px, b.fx_px);
    EXPECT_EQ(a.fy_px, b.fy_px);
    EXPECT_EQ(a.cx_px, b.cx_px);
    EXPECT_EQ(a.cy_px, b.cy_px);
    EXPECT_EQ(a.distortion, b.distortion);
    EXPECT_EQ(a.mount.height_m, b.mount.height_m);
    EXPECT_EQ(a.mount.pitch_rad, b.mount.pitch_rad);
    EXPECT_EQ(a.mount.roll_rad, b.mount.roll_rad);
    EXPECT_EQ(a.mount.yaw_rad, b.mount.yaw_rad);
    EXPECT_EQ(a.mount.forward_m, b.mount.forward_m);
    EXPECT_EQ(a.mount.left_m, b.mount.left_m);
}

void expect_equal(const EgoMotion& a, const EgoMotion& b) {
    EXPECT_EQ(a.omega_rad, b.omega_rad);
    EXPECT_EQ(a.pitch_rad, b.pitch_rad);
    EXPECT_EQ(a.forward_m, b.forward_m);
    EXPECT_EQ(a.chord_rad, b.chord_rad);
    EXPECT_EQ(a.sigma_omega_rad, b.sigma_omega_rad);
    EXPECT_EQ(a.sigma_forward_m, b.sigma_forward_m);
    EXPECT_EQ(a.omega_measured, b.omega_measured);
    EXPECT_EQ(a.forward_measured, b.forward_measured);
    EXPECT_EQ(a.omega_source, b.omega_source);
    EXPECT_EQ(a.forward_source, b.forward_source);
    EXPECT_EQ(a.inliers, b.inliers);
    EXPECT_EQ(a.ground_window, b.ground_window);
}

void expect_equal(const pipeline::BlockCounts& a, const pipeline::BlockCounts& b) {
    EXPECT_EQ(a.placed, b.placed);
    EXPECT_EQ(a.confident, b.confident);
    EXPECT_EQ(a.inliers, b.inliers);
    EXPECT_EQ(a.ground_window, b.ground_window);
    EXPECT_EQ(a.ground, b.ground);
    EXPECT_EQ(a.obstacle, b.obstacle);
    EXPECT_EQ(a.eliminated, b.eliminated);
    EXPECT_EQ(a.unsupported, b.unsupported);
    EXPECT_EQ(a.moving, b.moving);
}

void expect_equal(const pipeline::BlockRecord& a, const pipeline::BlockRecord& b) {
    EXPECT_EQ(a.vector.at_px, b.vector.at_px);
    EXPECT_EQ(a.vector.flow_px, b.vector.flow_px);
    EXPECT_EQ(a.vector.sigma_px, b.vector.sigma_px);
    EXPECT_EQ(a.vector.confidence, b.vector.confidence);
    EXPECT_EQ(a.vector.valid, b.vector.valid);
    EXPECT_EQ(a.predicted_px, b.predicted_px);
    EXPECT_EQ(a.ray.at, b.ray.at);
    EXPECT_EQ(a.ray.flow, b.ray.flow);
    EXPECT_EQ(a.ray.sigma, b.ray.sigma);
    EXPECT_EQ(a.image_of_cycle, b.image_of_cycle);
    EXPECT_EQ(a.label, b.label);
    EXPECT_EQ(a.in_ground_window, b.in_ground_window);
    EXPECT_EQ(a.fresh, b.fresh);
    EXPECT_EQ(a.omega_rad, b.omega_rad);
    EXPECT_EQ(a.excess_px, b.excess_px);
}

void expect_equal(const ObstaclePoint& a, const ObstaclePoint& b) {
    EXPECT_EQ(a.position_m, b.position_m);
    EXPECT_EQ(a.sigma_m, b.sigma_m);
    EXPECT_EQ(a.at_px, b.at_px);
    EXPECT_EQ(a.moving, b.moving);
}

void expect_equal(const GroundPatch& a, const GroundPatch& b) {
    EXPECT_EQ(a.width_m, b.width_m);
    EXPECT_EQ(a.near_m, b.near_m);
    EXPECT_EQ(a.far_m, b.far_m);
}

void expect_equal(const Beam& a, const Beam& b) {
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.range_m, b.range_m);
    EXPECT_EQ(a.cause, b.cause);
    EXPECT_EQ(a.near_m, b.near_m);
    EXPECT_EQ(a.far_m, b.far_m);
}

void expect_equal(const ContactStrip& a, const ContactStrip& b) {
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.cause, b.cause);
    EXPECT_EQ(a.free_m, b.free_m);
    EXPECT_EQ(a.contact_m, b.contact_m);
    EXPECT_EQ(a.near_m, b.near_m);
    EXPECT_EQ(a.far_m, b.far_m);
    EXPECT_EQ(a.score, b.score);
    EXPECT_EQ(a.seen, b.seen);
}

void expect_equal(const FloorFit& a, const FloorFit& b) {
    EXPECT_EQ(a.forward_m, b.forward_m);
    EXPECT_EQ(a.omega_rad, b.omega_rad);
    EXPECT_EQ(a.pitch_rad, b.pitch_rad);
    EXPECT_EQ(a.roll_rad, b.roll_rad);
    EXPECT_EQ(a.tilt_pitch_rad, b.tilt_pitch_rad);
    EXPECT_EQ(a.tilt_roll_rad, b.tilt_roll_rad);
    EXPECT_EQ(a.fit_share, b.fit_share);
    EXPECT_EQ(a.vignetting, b.vignetting);
}

template <typename Element>
void expect_equal(const std::vector<Element>& a, const std::vector<Element>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        SCOPED_TRACE(i);
        expect_equal(a[i], b[i]);
    }
}

void expect_equal(const ContactScan& a, const ContactScan& b) {
    EXPECT_EQ(a.gate, b.gate);
    EXPECT_EQ(a.first, b.first);
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.camera_m, b.camera_m);
    EXPECT_EQ(a.T_robot_scan.x_m, b.T_robot_scan.x_m);
    EXPECT_EQ(a.T_robot_scan.y_m, b.T_robot_scan.y_m);
    EXPECT_EQ(a.T_robot_scan.yaw_rad, b.T_robot_scan.yaw_rad);
    expect_equal(a.floor, b.floor);
    expect_equal(a.strips, b.strips);
}

void expect_equal(const pipeline::Step& a, const pipeline::Step& b) {
    EXPECT_EQ(a.timestamp_s, b.timestamp_s);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.restarted, b.restarted);
    EXPECT_EQ(a.image_of_cycle, b.image_of_cycle);
    EXPECT_EQ(a.cycle_images, b.cycle_images);
    EXPECT_EQ(a.end_of_cycle, b.end_of_cycle);
    EXPECT_EQ(a.omega_radps, b.omega_radps);
    EXPECT_EQ(a.pitch_rate_radps, b.pitch_rate_radps);
    EXPECT_EQ(a.v_mps, b.v_mps);
    EXPECT_EQ(a.v_measured, b.v_measured);
    EXPECT_EQ(a.pitch_correction_rad, b.pitch_correction_rad);
    expect_equal(a.motion, b.motion);
    EXPECT_EQ(a.T_start_robot.x_m, b.T_start_robot.x_m);
    EXPECT_EQ(a.T_start_robot.y_m, b.T_start_robot.y_m);
    EXPECT_EQ(a.T_start_robot.yaw_rad, b.T_start_robot.yaw_rad);
    expect_equal(a.counts, b.counts);
    expect_equal(a.blocks, b.blocks);
    expect_equal(a.obstacles, b.obstacles);
    expect_equal(a.ground, b.ground);
    EXPECT_EQ(a.scan.first_bearing_rad, b.scan.first_bearing_rad);
    EXPECT_EQ(a.scan.step_rad, b.scan.step_rad);
    expect_equal(a.scan.beams, b.scan.beams);
    EXPECT_EQ(a.new_contacts, b.new_contacts);
    expect_equal(a.contacts, b.contacts);
}

}  // namespace

CObservationFlowField::Ptr rich_flow_field() {
    return flow_field_observation(finished_cycle(), camera());
}

CObservationFlowField::Ptr rich_flow_field_of_version(int version) {
    auto field = rich_flow_field();
    pipeline::Step& step = field->step;
    if (version < 2) {
        step.motion.omega_source = MotionSource::Flow;
        step.scan.beams.resize(3);
        Beam& obstacle = step.scan.beams.back();
        obstacle = {BeamKind::Obstacle, obstacle.range_m, BeamCause::Blocks, obstacle.range_m,
                    obstacle.range_m};
        step.new_contacts = false;
        step.contacts = {};
    }
    if (version < 1)
        for (GroundPatch& patch : step.ground) patch.width_m = 0.0;
    return field;
}

CObservationFlowField::Ptr first_flow_field() {
    pipeline::Step step;
    step.timestamp_s = start_s;
    return flow_field_observation(step, camera());
}

void expect_equal(const CObservationFlowField& a, const CObservationFlowField& b) {
    EXPECT_EQ(a.timestamp, b.timestamp);
    EXPECT_EQ(a.sensorLabel, b.sensorLabel);
    expect_equal(a.camera, b.camera);
    expect_equal(a.step, b.step);
}

}  // namespace flownav::testing
