#include "step_samples.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace flownav::testing {

namespace {

Pose2 pose_at(int i, double omega_radps, double v_mps) {
    Pose2 pose;
    for (int k = 0; k < i; ++k) pose = compose(pose, along_arc(omega_radps * period_s, v_mps * period_s));
    return pose;
}

pipeline::BlockRecord block(double u, double v, BlockLabel label) {
    pipeline::BlockRecord record;
    record.vector.at_px = {u, v};
    record.vector.flow_px = {4.0, 12.0};
    record.vector.confidence = 0.5;
    record.vector.valid = label != BlockLabel::Sifted;
    record.label = label;
    return record;
}

ContactStrip free_to(double free_m) {
    ContactStrip strip;
    strip.kind = BeamKind::Free;
    strip.free_m = free_m;
    strip.seen = true;
    return strip;
}

/// A contact at the first distance, between the second and the third.
ContactStrip blocked(BeamCause cause, const std::array<double, 3>& contact_m, double free_m, double score) {
    return {BeamKind::Obstacle, cause, free_m, contact_m[0], contact_m[1], contact_m[2], score, true};
}

/// From left to right: votes, free, unknown, free, wall, drop; 0.1 in the tangent each.
ContactScan contacts() {
    ContactScan scan;
    scan.gate = ContactGate::Open;
    scan.first = -3;
    scan.step = 0.1;
    scan.camera_m = {0.1, 0.05};
    scan.floor.fit_share = 0.81;
    scan.floor.vignetting = 0.2;
    scan.strips = {blocked(BeamCause::Votes, {1.5, 1.4, 1.7}, 1.2, 210.0),
                   free_to(3.0),
                   {},
                   free_to(2.5),
                   blocked(BeamCause::Wall, {2.0, 1.9, 2.2}, 1.8, 0.0),
                   blocked(BeamCause::Drop, {1.0, 1.0, 1.2}, 0.9, 12.0)};
    return scan;
}

}  // namespace

pipeline::Step step_at(int i, double omega_radps, double v_mps) {
    pipeline::Step step;
    step.timestamp_s = start_s + i * period_s;
    step.status = i == 0 ? FieldStatus::Waiting : FieldStatus::Ok;
    step.image_of_cycle = i == 0 ? 0 : (i - 1) % cycle_images + 1;
    step.cycle_images = cycle_images;
    step.end_of_cycle = step.image_of_cycle == cycle_images;
    step.T_start_robot = pose_at(i, omega_radps, v_mps);
    if (i == 0) return step;
    step.omega_radps = omega_radps;
    step.pitch_rate_radps = -0.001;
    step.v_mps = v_mps;
    step.v_measured = step.end_of_cycle;
    step.motion.omega_measured = step.motion.forward_measured = true;
    step.motion.omega_source = step.motion.forward_source = MotionSource::Flow;
    step.counts.placed = 350;
    step.counts.confident = 320;
    step.counts.inliers = 300;
    step.counts.ground_window = 20;
    step.motion.omega_source = MotionSource::Flow;
    step.motion.forward_source = MotionSource::Wheels;
    step.blocks = {block(100, 50, BlockLabel::Obstacle), block(300, 100, BlockLabel::Ground),
                   block(500, 200, BlockLabel::Sifted)};
    if (!step.end_of_cycle) return step;
    step.obstacles = {{{2.0, 0.5, 0.3}, 0.05, {104.0, 62.0}}, {{3.0, -0.25, 0.6}, 0.1, {600.5, 20.25}}};
    step.ground = {{{1.0, 0.0}, {1.5, 0.0}}};
    step.scan = {-0.1, 0.1, {{BeamKind::Unknown, 0.0}, {BeamKind::Free, 1.5}, {BeamKind::Obstacle, 2.0}}};
    step.new_contacts = true;
    step.contacts = contacts();
    return step;
}

Field pal_field(int i) {
    constexpr int width = 768;
    constexpr int height = 288;
    auto pixels = std::make_shared<std::vector<std::uint8_t>>(width * height);
    for (std::size_t k = 0; k < pixels->size(); ++k)
        (*pixels)[k] = static_cast<std::uint8_t>(k % width / 6 + 60);
    Field field;
    field.timestamp_s = start_s + i * period_s;
    field.image = {pixels->data(), width, height, width};
    field.camera = {width, height, 737.6, 368.8, 383.5, 143.25, {0.1, -0.05, 0.001, 0.002, 0.01}, {}};
    field.camera.mount = {0.9, 0.4363, 0.02, -0.03, 0.1, 0.05};
    field.owner = pixels;
    return field;
}

evaluation::Drive sample_drive(int fields) {
    evaluation::Drive drive;
    drive.input_name = "sample.rawlog";
    drive.end.kind = io::ReadEnd::Kind::Clean;
    drive.end.objects_read = static_cast<std::uint64_t>(fields);
    drive.read.fields = static_cast<std::uint64_t>(fields);
    for (int i = 0; i < fields; ++i) {
        const pipeline::Step step = step_at(i);
        const Pose2& pose = step.T_start_robot;
        drive.rows.push_back(evaluation::row_of(step));
        drive.odometry.add(step.timestamp_s, {pose.x_m, pose.y_m, 0, pose.yaw_rad, 0, 0});
        drive.ground_truth.add(step.timestamp_s, {pose.x_m, pose.y_m, 0, pose.yaw_rad, 0, 0});
    }
    drive.odometry.finish();
    drive.ground_truth.finish();
    drive.odometry_errors = evaluation::compare(drive.rows, drive.odometry);
    drive.ground_truth_errors = evaluation::compare(drive.rows, drive.ground_truth);
    return drive;
}

report::ThumbnailStrip sample_thumbnail_strip(int fields) {
    report::ThumbnailStrip thumbnail_strip;
    for (int i = 0; i < fields; ++i) thumbnail_strip.offer(pal_field(i), step_at(i));
    return thumbnail_strip;
}

std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    EXPECT_TRUE(stream) << file;
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

}  // namespace flownav::testing
