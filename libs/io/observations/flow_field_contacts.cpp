#include "flow_field_contacts.h"

#include "archive_parts.h"
#include "stored_words.h"

namespace flownav {

using namespace io::archive;

namespace {

using pipeline::Step;

void write_strip(CArchive& out, const ContactStrip& s) {
    out << number_of(s.kind, stored_kinds) << number_of(s.cause, stored_causes);
    write_numbers<5>(out, {s.free_m, s.contact_m, s.near_m, s.far_m, s.score});
    write_flags(out, {s.seen});
}

ContactStrip read_strip(CArchive& in) {
    ContactStrip s;
    s.kind = read_word(in, stored_kinds, "a strip");
    s.cause = read_word(in, stored_causes, "the cause of a strip");
    const auto n = read_numbers<5>(in);
    s.free_m = n[0];
    s.contact_m = n[1];
    s.near_m = n[2];
    s.far_m = n[3];
    s.score = n[4];
    read_flags(in, {&s.seen});
    return s;
}

void write_floor(CArchive& out, const FloorFit& f) {
    write_numbers<8>(out, {f.forward_m, f.omega_rad, f.pitch_rad, f.roll_rad, f.tilt_pitch_rad,
                           f.tilt_roll_rad, f.fit_share, f.vignetting});
}

FloorFit read_floor(CArchive& in) {
    const auto n = read_numbers<8>(in);
    return {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]};
}

void write_scan(CArchive& out, const ContactScan& scan) {
    out << number_of(scan.gate, stored_gates);
    out.WriteAs<std::int32_t>(scan.first);
    const Pose2& T = scan.T_robot_scan;
    write_numbers<6>(out, {scan.step, scan.camera_m.x(), scan.camera_m.y(), T.x_m, T.y_m, T.yaw_rad});
    write_floor(out, scan.floor);
    write_list(out, scan.strips, write_strip);
}

ContactScan read_scan(CArchive& in) {
    ContactScan scan;
    scan.gate = read_word(in, stored_gates, "the gate of the contact scan");
    scan.first = in.ReadAs<std::int32_t>();
    const auto n = read_numbers<6>(in);
    scan.step = n[0];
    scan.camera_m = {n[1], n[2]};
    scan.T_robot_scan = {n[3], n[4], n[5]};
    scan.floor = read_floor(in);
    scan.strips = read_list(in, "strips", read_strip);
    return scan;
}

}  // namespace

void write_contact_part(CArchive& out, const Step& step) {
    out << number_of(step.motion.omega_source, stored_sources)
        << number_of(step.motion.forward_source, stored_sources);
    for (const Beam& beam : step.scan.beams) {
        out << number_of(beam.cause, stored_causes);
        write_numbers<2>(out, {beam.near_m, beam.far_m});
    }
    write_flags(out, {step.new_contacts});
    if (step.new_contacts) write_scan(out, step.contacts);
}

void read_contact_part(CArchive& in, Step& step) {
    step.motion.omega_source = read_word(in, stored_sources, "the source of the turn");
    step.motion.forward_source = read_word(in, stored_sources, "the source of the travel");
    for (Beam& beam : step.scan.beams) {
        beam.cause = read_word(in, stored_causes, "the cause of a beam");
        const auto interval = read_numbers<2>(in);
        beam.near_m = interval[0];
        beam.far_m = interval[1];
    }
    read_flags(in, {&step.new_contacts});
    if (step.new_contacts) step.contacts = read_scan(in);
}

void complete_older_step(Step& step) {
    const auto source = [](bool measured) {
        return measured ? MotionSource::Flow : MotionSource::Prediction;
    };
    step.motion.omega_source = source(step.motion.omega_measured);
    step.motion.forward_source = source(step.motion.forward_measured);
    for (Beam& beam : step.scan.beams) {
        if (beam.kind != BeamKind::Obstacle) continue;
        beam.cause = BeamCause::Blocks;
        beam.near_m = beam.far_m = beam.range_m;
    }
}

}  // namespace flownav
