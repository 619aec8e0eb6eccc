#include "flow_field_archive.h"

#include "archive_parts.h"
#include "flow_field_contacts.h"
#include "stored_words.h"

namespace flownav {

using namespace io::archive;

namespace {

using pipeline::BlockCounts;
using pipeline::BlockRecord;
using pipeline::Step;

void write_block(CArchive& out, const BlockRecord& b) {
    const FlowVector& v = b.vector;
    write_numbers<17>(
        out, {v.at_px.x(), v.at_px.y(), v.flow_px.x(), v.flow_px.y(), v.sigma_px.x(), v.sigma_px.y(),
              v.confidence, b.predicted_px.x(), b.predicted_px.y(), b.ray.at.x(), b.ray.at.y(),
              b.ray.flow.x(), b.ray.flow.y(), b.ray.sigma.x(), b.ray.sigma.y(), b.omega_rad, b.excess_px});
    out.WriteAs<std::int32_t>(b.image_of_cycle);
    out << number_of(b.label, stored_labels);
    write_flags(out, {v.valid, b.in_ground_window, b.fresh});
}

BlockRecord read_block(CArchive& in) {
    const auto n = read_numbers<17>(in);
    BlockRecord b;
    b.vector.at_px = {n[0], n[1]};
    b.vector.flow_px = {n[2], n[3]};
    b.vector.sigma_px = {n[4], n[5]};
    b.vector.confidence = n[6];
    b.predicted_px = {n[7], n[8]};
    b.ray = {{n[9], n[10]}, {n[11], n[12]}, {n[13], n[14]}};
    b.omega_rad = n[15];
    b.excess_px = n[16];
    b.image_of_cycle = in.ReadAs<std::int32_t>();
    b.label = read_word(in, stored_labels, "the fate of a block");
    read_flags(in, {&b.vector.valid, &b.in_ground_window, &b.fresh});
    return b;
}

void write_obstacle(CArchive& out, const ObstaclePoint& p) {
    write_numbers<6>(
        out, {p.position_m.x(), p.position_m.y(), p.position_m.z(), p.sigma_m, p.at_px.x(), p.at_px.y()});
    write_flags(out, {p.moving});
}

ObstaclePoint read_obstacle(CArchive& in) {
    const auto n = read_numbers<6>(in);
    ObstaclePoint p{{n[0], n[1], n[2]}, n[3], {n[4], n[5]}};
    read_flags(in, {&p.moving});
    return p;
}

void write_patch(CArchive& out, const GroundPatch& patch) {
    write_numbers<4>(out, {patch.near_m.x(), patch.near_m.y(), patch.far_m.x(), patch.far_m.y()});
}

GroundPatch read_patch(CArchive& in) {
    const auto n = read_numbers<4>(in);
    return {{n[0], n[1]}, {n[2], n[3]}};
}

void write_beam(CArchive& out, const Beam& beam) {
    out << number_of(beam.kind, stored_kinds);
    out << beam.range_m;
}

Beam read_beam(CArchive& in) {
    const BeamKind kind = read_word(in, stored_kinds, "a beam");
    return {kind, in.ReadAs<double>()};
}

void write_motion(CArchive& out, const EgoMotion& m) {
    write_numbers<6>(
        out, {m.omega_rad, m.pitch_rad, m.forward_m, m.chord_rad, m.sigma_omega_rad, m.sigma_forward_m});
    write_flags(out, {m.omega_measured, m.forward_measured});
    out.WriteAs<std::int32_t>(m.inliers).WriteAs<std::int32_t>(m.ground_window);
}

EgoMotion read_motion(CArchive& in) {
    const auto n = read_numbers<6>(in);
    EgoMotion m{n[0], n[1], n[2], n[3], n[4], n[5]};
    read_flags(in, {&m.omega_measured, &m.forward_measured});
    m.inliers = in.ReadAs<std::int32_t>();
    m.ground_window = in.ReadAs<std::int32_t>();
    return m;
}

// Counts in the order in which they are stored.
constexpr std::array stored_counts = {
    &BlockCounts::placed,        &BlockCounts::confident,   &BlockCounts::inliers,
    &BlockCounts::ground_window, &BlockCounts::ground,      &BlockCounts::obstacle,
    &BlockCounts::eliminated,    &BlockCounts::unsupported, &BlockCounts::moving};

}  // namespace

void write_camera(CArchive& out, const CameraModel& c) {
    out.WriteAs<std::int32_t>(c.width_px).WriteAs<std::int32_t>(c.height_px);
    write_numbers<4>(out, {c.fx_px, c.fy_px, c.cx_px, c.cy_px});
    write_numbers(out, c.distortion);
    const CameraMount& m = c.mount;
    write_numbers<6>(out, {m.height_m, m.pitch_rad, m.roll_rad, m.yaw_rad, m.forward_m, m.left_m});
}

CameraModel read_camera(CArchive& in) {
    CameraModel c;
    c.width_px = in.ReadAs<std::int32_t>();
    c.height_px = in.ReadAs<std::int32_t>();
    const auto lens = read_numbers<4>(in);
    c.fx_px = lens[0];
    c.fy_px = lens[1];
    c.cx_px = lens[2];
    c.cy_px = lens[3];
    c.distortion = read_numbers<5>(in);
    const auto m = read_numbers<6>(in);
    c.mount = {m[0], m[1], m[2], m[3], m[4], m[5]};
    return c;
}

void write_step(CArchive& out, const Step& s) {
    write_numbers<8>(out, {s.timestamp_s, s.omega_radps, s.pitch_rate_radps, s.v_mps, s.pitch_correction_rad,
                           s.T_start_robot.x_m, s.T_start_robot.y_m, s.T_start_robot.yaw_rad});
    out << number_of(s.status, stored_statuses);
    write_flags(out, {s.restarted, s.end_of_cycle, s.v_measured});
    out.WriteAs<std::int32_t>(s.image_of_cycle).WriteAs<std::int32_t>(s.cycle_images);
    write_motion(out, s.motion);
    for (const auto count : stored_counts) out.WriteAs<std::int32_t>(s.counts.*count);
    write_list(out, s.blocks, write_block);
    write_list(out, s.obstacles, write_obstacle);
    write_list(out, s.ground, write_patch);
    write_numbers<2>(out, {s.scan.first_bearing_rad, s.scan.step_rad});
    write_list(out, s.scan.beams, write_beam);
    for (const GroundPatch& patch : s.ground) write_numbers<1>(out, {patch.width_m});
    write_contact_part(out, s);
}

Step read_step(CArchive& in, int version) {
    Step s;
    const auto n = read_numbers<8>(in);
    s.timestamp_s = n[0];
    s.omega_radps = n[1];
    s.pitch_rate_radps = n[2];
    s.v_mps = n[3];
    s.pitch_correction_rad = n[4];
    s.T_start_robot = {n[5], n[6], n[7]};
    s.status = read_word(in, stored_statuses, "the status");
    read_flags(in, {&s.restarted, &s.end_of_cycle, &s.v_measured});
    s.image_of_cycle = in.ReadAs<std::int32_t>();
    s.cycle_images = in.ReadAs<std::int32_t>();
    s.motion = read_motion(in);
    for (const auto count : stored_counts) s.counts.*count = in.ReadAs<std::int32_t>();
    s.blocks = read_list(in, "blocks", read_block);
    s.obstacles = read_list(in, "obstacle points", read_obstacle);
    s.ground = read_list(in, "patches of floor", read_patch);
    const auto bearings = read_numbers<2>(in);
    s.scan.first_bearing_rad = bearings[0];
    s.scan.step_rad = bearings[1];
    s.scan.beams = read_list(in, "beams", read_beam);
    if (version >= 1)
        for (GroundPatch& patch : s.ground) patch.width_m = read_numbers<1>(in)[0];
    if (version >= 2) {
        read_contact_part(in, s);
    } else {
        complete_older_step(s);
    }
    return s;
}

}  // namespace flownav
