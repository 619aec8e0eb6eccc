#include "flow_field_archive.h"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace flownav {
namespace {

using mrpt::serialization::CArchive;
using pipeline::BlockCounts;
using pipeline::BlockRecord;
using pipeline::Step;

// The index of a value is stored in files: append new values, never reorder.
constexpr std::array stored_status = {FieldStatus::Ok, FieldStatus::Waiting, FieldStatus::Lost,
                                      FieldStatus::NoTexture, FieldStatus::BadField};
constexpr std::array stored_label = {BlockLabel::Unplaced,    BlockLabel::Sifted,   BlockLabel::Eliminated,
                                     BlockLabel::Ground,      BlockLabel::Obstacle, BlockLabel::Moving,
                                     BlockLabel::Unsupported, BlockLabel::Unjudged};
constexpr std::array stored_kind = {BeamKind::Unknown, BeamKind::Free, BeamKind::Obstacle};

constexpr std::uint32_t most_elements = 1U << 20;

template <typename Word, std::size_t N>
std::uint8_t number_of(Word word, const std::array<Word, N>& words) {
    return static_cast<std::uint8_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

template <typename Word, std::size_t N>
Word read_word(CArchive& in, const std::array<Word, N>& words, const char* name) {
    const auto number = in.ReadAs<std::uint8_t>();
    if (number < N) return words[number];
    throw std::runtime_error("flow field: " + std::string(name) + " has the number " +
                             std::to_string(number) + ", known are 0.." + std::to_string(N - 1));
}

/// Writes flags as bits of one byte, the first flag in the lowest bit.
void write_flags(CArchive& out, std::initializer_list<bool> flags) {
    unsigned bits = 0;
    unsigned place = 0;
    for (const bool flag : flags) bits |= static_cast<unsigned>(flag) << place++;
    out << static_cast<std::uint8_t>(bits);
}

void read_flags(CArchive& in, std::initializer_list<bool*> flags) {
    unsigned bits = in.ReadAs<std::uint8_t>();
    for (bool* flag : flags) {
        *flag = (bits & 1U) != 0;
        bits >>= 1U;
    }
    if (bits != 0) throw std::runtime_error("flow field: a flag is set that does not exist");
}

/// A row of N doubles, written and read as one buffer.
template <std::size_t N>
using Numbers = std::array<double, N>;

template <std::size_t N>
void write_numbers(CArchive& out, const Numbers<N>& numbers) {
    out.WriteBufferFixEndianness(numbers.data(), N);
}

template <std::size_t N>
Numbers<N> read_numbers(CArchive& in) {
    Numbers<N> numbers{};
    if (in.ReadBufferFixEndianness(numbers.data(), N) != sizeof(numbers))
        throw std::runtime_error("flow field: ends in the middle of its numbers");
    return numbers;
}

template <typename Element, typename Write>
void write_list(CArchive& out, const std::vector<Element>& list, Write write_element) {
    out.WriteAs<std::uint32_t>(list.size());
    for (const Element& element : list) write_element(out, element);
}

/// Reads a list element by element, so that a damaged length does not allocate memory for it.
template <typename Read>
auto read_list(CArchive& in, const char* name, Read read_element) {
    std::vector<decltype(read_element(in))> list;
    const auto size = in.ReadAs<std::uint32_t>();
    if (size > most_elements) {
        throw std::runtime_error("flow field: " + std::to_string(size) + ' ' + name + " are more than the " +
                                 std::to_string(most_elements) + " that can be: the file is damaged");
    }
    for (std::uint32_t i = 0; i < size; ++i) list.push_back(read_element(in));
    return list;
}

void write_block(CArchive& out, const BlockRecord& b) {
    const FlowVector& v = b.vector;
    write_numbers<17>(
        out, {v.at_px.x(), v.at_px.y(), v.flow_px.x(), v.flow_px.y(), v.sigma_px.x(), v.sigma_px.y(),
              v.confidence, b.predicted_px.x(), b.predicted_px.y(), b.ray.at.x(), b.ray.at.y(),
              b.ray.flow.x(), b.ray.flow.y(), b.ray.sigma.x(), b.ray.sigma.y(), b.omega_rad, b.excess_px});
    out.WriteAs<std::int32_t>(b.image_of_cycle);
    out << number_of(b.label, stored_label);
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
    b.label = read_word(in, stored_label, "the fate of a block");
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
    out << number_of(beam.kind, stored_kind);
    out << beam.range_m;
}

Beam read_beam(CArchive& in) {
    const BeamKind kind = read_word(in, stored_kind, "a beam");
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

template <typename Word, std::size_t N>
std::string explained(const std::array<Word, N>& words) {
    std::string text;
    for (std::size_t i = 0; i < N; ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(i) + " = " + to_string(words[i]);
    return text;
}

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
    out << number_of(s.status, stored_status);
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
    s.status = read_word(in, stored_status, "the status");
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
    return s;
}

int stored_number(FieldStatus status) {
    return number_of(status, stored_status);
}

int stored_number(BlockLabel label) {
    return number_of(label, stored_label);
}

std::string stored_statuses() {
    return explained(stored_status);
}

std::string stored_labels() {
    return explained(stored_label);
}

}  // namespace flownav
