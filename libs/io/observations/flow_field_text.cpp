#include <algorithm>
#include <map>
#include <sstream>

#include "archive_parts.h"
#include "flownav/core/strip_counts.h"
#include "flownav/io/flow_field_observation.h"
#include "flownav/math/units.h"
#include "stored_words.h"

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
        << fixed(deg(m.omega_rad), 3) << " +- " << fixed(deg(m.sigma_omega_rad), 3) << " deg ("
        << (m.omega_measured ? to_string(m.omega_source) : "predicted") << "), pitch "
        << fixed(deg(m.pitch_rad), 3) << " deg, forward " << fixed(m.forward_m, 4) << " +- "
        << fixed(m.sigma_forward_m, 4) << " m ("
        << (m.forward_measured ? to_string(m.forward_source) : "carried over")
        << ")\nPose since the start: x " << fixed(s.T_start_robot.x_m, 3) << " m, y "
        << fixed(s.T_start_robot.y_m, 3) << " m, heading " << fixed(deg(s.T_start_robot.yaw_rad), 2)
        << " deg; pitch of the camera corrected by " << fixed(deg(s.pitch_correction_rad), 3) << " deg\n";
}

void describe_blocks(std::ostream& out, const Step& s) {
    const BlockCounts& c = s.counts;
    out << "Blocks: " << s.blocks.size() << "; placed " << c.placed << ", confident " << c.confident
        << ", inliers " << c.inliers << ", ground window " << c.ground_window << "\n  by fate:";
    std::map<int, std::pair<BlockLabel, int>> by_fate;
    for (const BlockRecord& b : s.blocks) {
        auto& [label, count] = by_fate[io::archive::number_of(b.label, io::archive::stored_labels)];
        label = b.label;
        ++count;
    }
    for (const auto& [number, entry] : by_fate) out << ' ' << to_string(entry.first) << ' ' << entry.second;
    out << (by_fate.empty() ? " none\n" : "\n");
}

/// Writes one strip that ends at an obstacle.
void describe_contact(std::ostream& out, const ContactScan& scan, int i) {
    const ContactStrip& strip = scan.strips[static_cast<std::size_t>(i)];
    const Eigen::Vector2d at_m = point_of(scan, middle_tangent(scan, i), strip.contact_m);
    out << "  " << to_string(strip.cause) << " at " << fixed(at_m.x(), 2) << ' ' << fixed(at_m.y(), 2)
        << " m, " << fixed(strip.near_m, 2) << " to " << fixed(strip.far_m, 2)
        << " m ahead of the camera, score " << fixed(strip.score, 0) << '\n';
}

void describe_contacts(std::ostream& out, const Step& s) {
    if (!s.new_contacts) {
        out << "Contact scan: none with this field\n";
        return;
    }
    const ContactScan& scan = s.contacts;
    const StripCounts counts = counts_of(scan);
    out << "Contact scan: " << to_string(scan.gate) << "; " << scan.strips.size() << " strips, "
        << counts.obstacle << " end at an obstacle, " << counts.free << " are free, " << counts.unknown
        << " unknown; share of the near floor that fits " << fixed(scan.floor.fit_share, 2) << ", vignetting "
        << fixed(scan.floor.vignetting, 2) << '\n';
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i)
        if (scan.strips[static_cast<std::size_t>(i)].kind == BeamKind::Obstacle)
            describe_contact(out, scan, i);
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
    describe_contacts(out, step);
}

}  // namespace flownav
