#include <array>
#include <charconv>

#include "archive_parts.h"
#include "flownav/io/flow_field_observation.h"
#include "stored_words.h"

namespace flownav {

using namespace io::archive;

namespace {

using pipeline::BlockCounts;
using pipeline::BlockRecord;
using pipeline::Step;

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
    Row& operator()(std::uint8_t value) { return word(std::to_string(value)); }
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
constexpr auto contact_columns =
    "turn_source forward_source new_contacts gate floor_fit vignetting scan_x_m scan_y_m scan_yaw_rad";
constexpr auto strip_columns = "tangent_right kind cause free_m contact_m near_m far_m score seen";

void put_field(Row& row, const Step& s) {
    row(number_of(s.status, stored_statuses))(s.restarted)(s.image_of_cycle)(s.cycle_images)(s.end_of_cycle);
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
    row(number_of(b.label, stored_labels))(b.image_of_cycle)(b.in_ground_window)(b.fresh);
}

void put_obstacle(Row& row, const ObstaclePoint& p) {
    row(p.position_m.x())(p.position_m.y())(p.position_m.z())(p.sigma_m)(p.at_px)(p.moving);
}

/// The scan's numbers are those of its defaults when it is not new.
void put_contacts(Row& row, const Step& s) {
    const ContactScan scan = s.new_contacts ? s.contacts : ContactScan{};
    row(number_of(s.motion.omega_source, stored_sources))(number_of(s.motion.forward_source, stored_sources));
    row(s.new_contacts)(number_of(scan.gate, stored_gates))(scan.floor.fit_share)(scan.floor.vignetting);
    row(scan.T_robot_scan.x_m)(scan.T_robot_scan.y_m)(scan.T_robot_scan.yaw_rad);
    row(scan.strips.size());
    for (std::size_t i = 0; i < scan.strips.size(); ++i) {
        const ContactStrip& strip = scan.strips[i];
        row(middle_tangent(scan, static_cast<int>(i)));
        row(number_of(strip.kind, stored_kinds))(number_of(strip.cause, stored_causes));
        row(strip.free_m)(strip.contact_m)(strip.near_m)(strip.far_m)(strip.score)(strip.seen);
    }
}

}  // namespace

std::string CObservationFlowField::exportTxtHeader() const {
    return std::string(field_columns) + " blocks obstacles, then for each block: " + block_columns +
           ", then for each obstacle: " + obstacle_columns + ", then " + contact_columns +
           " strips, then for each strip: " + strip_columns + " (status: " + explained(stored_statuses) +
           "; fate: " + explained(stored_labels) +
           "; turn_source, forward_source: " + explained(stored_sources) +
           "; gate: " + explained(stored_gates) + "; kind: " + explained(stored_kinds) +
           "; cause: " + explained(stored_causes) + "; 1 = yes, 0 = no)";
}

std::string CObservationFlowField::exportTxtDataRow() const {
    Row row;
    put_field(row, step);
    row(step.blocks.size())(step.obstacles.size());
    for (const BlockRecord& block : step.blocks) put_block(row, block);
    for (const ObstaclePoint& point : step.obstacles) put_obstacle(row, point);
    put_contacts(row, step);
    return row.text();
}

}  // namespace flownav
