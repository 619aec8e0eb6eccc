#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include "flow_field_archive.h"
#include "flownav/io/flow_field_observation.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

using pipeline::BlockCounts;
using pipeline::BlockRecord;
using pipeline::Step;

/// Text of `value` with a fixed number of decimals.
std::string fixed(double value, int decimals) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.setf(std::ios::fixed);
    text.precision(decimals);
    text << value;
    return text.str();
}

/// Builds a row of columns separated by blanks.
class Row {
  public:
    Row& operator()(double value) {
        std::array<char, 32> text{};
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 9);
        return word({text.data(), end.ptr});
    }
    Row& operator()(int value) { return word(std::to_string(value)); }
    Row& operator()(std::size_t value) { return word(std::to_string(value)); }
    Row& operator()(bool value) { return word(value ? "1" : "0"); }
    Row& operator()(const Eigen::Vector2d& v) { return (*this)(v.x())(v.y()); }
    std::string text() const { return text_; }

  private:
    Row& word(const std::string& text) {
        text_ += text_.empty() ? "" : " ";
        text_ += text;
        return *this;
    }
    std::string text_;
};

constexpr auto field_columns =
    "status restarted image_of_cycle cycle_images end_of_cycle omega_radps pitch_rate_radps v_mps v_measured "
    "pitch_correction_rad turn_rad pitch_rad forward_m chord_rad sigma_turn_rad sigma_forward_m "
    "turn_measured "
    "forward_measured x_m y_m yaw_rad placed confident inliers ground_window ground obstacle eliminated "
    "unsupported moving";
constexpr auto block_columns =
    "u_px v_px du_px dv_px sigma_du_px sigma_dv_px confidence valid predicted_du_px predicted_dv_px ray_x "
    "ray_y ray_dx ray_dy ray_sigma_dx ray_sigma_dy omega_rad excess_px fate image_of_cycle in_ground_window "
    "fresh";
constexpr auto obstacle_columns = "x_m y_m z_m sigma_m u_px v_px moving";

void put_field(Row& row, const Step& s) {
    row(stored_number(s.status))(s.restarted)(s.image_of_cycle)(s.cycle_images)(s.end_of_cycle);
    row(s.omega_radps)(s.pitch_rate_radps)(s.v_mps)(s.v_measured)(s.pitch_correction_rad);
    const EgoMotion& m = s.motion;
    row(m.omega_rad)(m.pitch_rad)(m.forward_m)(m.chord_rad)(m.sigma_omega_rad)(m.sigma_forward_m);
    row(m.omega_measured)(m.forward_measured);
    row(s.T_start_robot.x_m)(s.T_start_robot.y_m)(s.T_start_robot.yaw_rad);
    const BlockCounts& c = s.counts;
    row(c.placed)(c.confident)(c.inliers)(c.ground_window)(c.ground)(c.obstacle)(c.eliminated);
    row(c.unsupported)(c.moving);
}

void put_block(Row& row, const BlockRecord& b) {
    const FlowVector& v = b.vector;
    row(v.at_px)(v.flow_px)(v.sigma_px)(v.confidence)(v.valid)(b.predicted_px);
    row(b.ray.at)(b.ray.flow)(b.ray.sigma)(b.omega_rad)(b.excess_px);
    row(stored_number(b.label))(b.image_of_cycle)(b.in_ground_window)(b.fresh);
}

void put_obstacle(Row& row, const ObstaclePoint& p) {
    row(p.position_m.x())(p.position_m.y())(p.position_m.z())(p.sigma_m)(p.at_px)(p.moving);
}

void describe_camera(std::ostream& out, const CameraModel& c) {
    out << "Camera: " << c.width_px << " x " << c.height_px << " px, fx " << fixed(c.fx_px, 2) << ", fy "
        << fixed(c.fy_px, 2) << ", cx " << fixed(c.cx_px, 2) << ", cy " << fixed(c.cy_px, 2)
        << " px\n  height " << fixed(c.mount.height_m, 3) << " m, " << fixed(c.mount.forward_m, 3)
        << " m ahead of the axis and " << fixed(c.mount.left_m, 3) << " m to its left; pitch "
        << fixed(deg(c.mount.pitch_rad), 2) << " deg down, roll " << fixed(deg(c.mount.roll_rad), 2)
        << " deg, yaw " << fixed(deg(c.mount.yaw_rad), 2) << " deg\n";
}

void describe_motion(std::ostream& out, const Step& s) {
    const EgoMotion& m = s.motion;
    out << "Status: " << to_string(s.status) << (s.restarted ? ", a new chain begins here" : "") << "; image "
        << s.image_of_cycle << " of a cycle of " << s.cycle_images << (s.end_of_cycle ? ", the last one" : "")
        << "\nTurn rate " << fixed(deg(s.omega_radps), 3) << " deg/s (> 0 left), pitch rate "
        << fixed(deg(s.pitch_rate_radps), 3) << " deg/s, speed " << fixed(s.v_mps, 3) << " m/s "
        << (s.v_measured ? "(measured)" : "(predicted or carried over)") << "\nSince the reference: turn "
        << fixed(deg(m.omega_rad), 3) << " +- " << fixed(deg(m.sigma_omega_rad), 3) << " deg"
        << (m.omega_measured ? "" : " (predicted)") << ", pitch " << fixed(deg(m.pitch_rad), 3)
        << " deg, forward " << fixed(m.forward_m, 4) << " +- " << fixed(m.sigma_forward_m, 4) << " m"
        << (m.forward_measured ? "" : " (carried over)") << "\nPose since the start: x "
        << fixed(s.T_start_robot.x_m, 3) << " m, y " << fixed(s.T_start_robot.y_m, 3) << " m, heading "
        << fixed(deg(s.T_start_robot.yaw_rad), 2) << " deg; pitch of the camera corrected by "
        << fixed(deg(s.pitch_correction_rad), 3) << " deg\n";
}

void describe_blocks(std::ostream& out, const Step& s) {
    const BlockCounts& c = s.counts;
    out << "Blocks: " << s.blocks.size() << "; placed " << c.placed << ", confident " << c.confident
        << ", inliers " << c.inliers << ", ground window " << c.ground_window << "\n  by fate:";
    std::map<int, std::pair<BlockLabel, int>> by_fate;
    for (const BlockRecord& b : s.blocks) {
        auto& [label, count] = by_fate[stored_number(b.label)];
        label = b.label;
        ++count;
    }
    for (const auto& [number, entry] : by_fate) out << ' ' << to_string(entry.first) << ' ' << entry.second;
    out << (by_fate.empty() ? " none\n" : "\n");
}

void describe_obstacles(std::ostream& out, const Step& s) {
    constexpr std::size_t most_listed = 20;
    out << "Obstacle points: " << s.obstacles.size() << " (robot frame: x ahead, y left, z up; m)\n";
    for (std::size_t i = 0; i < std::min(s.obstacles.size(), most_listed); ++i) {
        const ObstaclePoint& p = s.obstacles[i];
        out << "  " << fixed(p.position_m.x(), 2) << ' ' << fixed(p.position_m.y(), 2) << ' '
            << fixed(p.position_m.z(), 2) << " +- " << fixed(p.sigma_m, 2) << " m"
            << (p.moving ? ", moves by itself" : "") << '\n';
    }
    if (s.obstacles.size() > most_listed) out << "  and " << s.obstacles.size() - most_listed << " more\n";
    const auto beams = [&s](BeamKind kind) {
        return std::count_if(s.scan.beams.begin(), s.scan.beams.end(),
                             [kind](const Beam& beam) { return beam.kind == kind; });
    };
    out << "Patches of floor: " << s.ground.size() << "\nScan: " << s.scan.beams.size() << " beams of "
        << fixed(deg(s.scan.step_rad), 2) << " deg from " << fixed(deg(s.scan.first_bearing_rad), 1)
        << " deg on; " << beams(BeamKind::Obstacle) << " end at an obstacle, " << beams(BeamKind::Free)
        << " are free, " << beams(BeamKind::Unknown) << " unknown\n";
}

}  // namespace

void CObservationFlowField::getDescriptionAsText(std::ostream& out) const {
    CObservation::getDescriptionAsText(out);
    describe_camera(out, camera);
    describe_motion(out, step);
    describe_blocks(out, step);
    describe_obstacles(out, step);
}

std::string CObservationFlowField::exportTxtHeader() const {
    return std::string(field_columns) + " blocks obstacles, then for each block: " + block_columns +
           ", then for each obstacle: " + obstacle_columns + " (status: " + stored_statuses() +
           "; fate: " + stored_labels() + "; 1 = yes, 0 = no)";
}

std::string CObservationFlowField::exportTxtDataRow() const {
    Row row;
    put_field(row, step);
    row(step.blocks.size())(step.obstacles.size());
    for (const BlockRecord& block : step.blocks) put_block(row, block);
    for (const ObstaclePoint& point : step.obstacles) put_obstacle(row, point);
    return row.text();
}

}  // namespace flownav
