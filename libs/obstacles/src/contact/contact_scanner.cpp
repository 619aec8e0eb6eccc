#include "flownav/obstacles/contact_scanner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "flownav/core/plane_geometry.h"
#include "flownav/obstacles/strip_rules.h"
#include "strip_grid.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

constexpr double vignetting_gain = 0.2;  // of one scan
constexpr double vignetting_max = 0.6;
constexpr double noise_gain = 0.2;
constexpr double noise_min = 0.4;
constexpr double noise_max = 6.0;
constexpr double turn_max_rad = 0.6;  // between the images of a scan
constexpr double way_error_min = 0.015;
constexpr double own_share = 0.15;   // of the votes of three strips: those of the middle one
constexpr int confirming_scans = 2;  // so many scans back
constexpr double same_place_m = 0.2;
constexpr double same_place_share = 0.12;  // of the distance
constexpr double one_surface = 0.3;        // largest relative step of range between strips of one surface

double way_m(const Pose2& a, const Pose2& b) {
    return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

void learn(ContactMemory& memory) {
    const FloorComparison& c = memory.comparison;
    memory.vignetting = std::clamp(memory.vignetting + vignetting_gain * c.vignetting, 0.0, vignetting_max);
    if (c.noise > 0.0)
        memory.noise = std::clamp(memory.noise + noise_gain * (c.noise - memory.noise), noise_min, noise_max);
}

void gather_evidence(const KeyImage& newer, const StripGrid& grid, const ContactParams& params,
                     ContactMemory& memory) {
    memory.evidence.assign(static_cast<std::size_t>(grid.strips), StripEvidence{});
    for (int s = 0; s < grid.strips; ++s) {
        memory.evidence[static_cast<std::size_t>(s)].votes =
            best_contact(newer.image, memory.votes, s, params.range_min_m, params.range_max_m);
    }
    find_floor_ends(newer.image, memory.comparison.cells, memory.evidence);
    find_walls(newer.image, memory.comparison.cells, params.range_max_m, memory.evidence);
}

/// Place of a contact, in the frame of T_start_robot.
Vector2d place_of(const ContactScan& scan, const Pose2& T_start_robot, int strip, double forward_m) {
    const double right = middle_tangent(scan, strip);
    return transform(T_start_robot, {scan.camera_m.x() + forward_m, scan.camera_m.y() - right * forward_m});
}

/// True when one of the first `count` earlier contacts was at this place.
bool was_seen_before(const ContactMemory& memory, std::size_t count, const Vector2d& place_m,
                     double forward_m) {
    const double tolerance_m = std::max(same_place_m, same_place_share * forward_m);
    for (std::size_t i = 0; i < count; ++i)
        if ((memory.earlier[i].place_m - place_m).norm() < tolerance_m) return true;
    return false;
}

void forget_old(ContactMemory& memory) {
    const auto is_old = [&](const EarlierContact& c) { return c.scan < memory.scans - confirming_scans; };
    memory.earlier.erase(std::remove_if(memory.earlier.begin(), memory.earlier.end(), is_old),
                         memory.earlier.end());
}

/// Mean of the ranges of a surface over five strips, weighted by their votes; without the strips of others.
double smooth_m(const std::vector<StripEvidence>& strips, int strip) {
    const auto at = [&](int s) -> const Contact& { return strips[static_cast<std::size_t>(s)].votes; };
    const double here_m = at(strip).forward_m;
    double sum = 0.0;
    double weight = 0.0;
    for (int s = std::max(0, strip - 2); s <= std::min(static_cast<int>(strips.size()) - 1, strip + 2); ++s) {
        if (std::abs(at(s).forward_m - here_m) > one_surface * here_m) continue;
        sum += at(s).score * at(s).forward_m;
        weight += at(s).score;
    }
    return sum / weight;
}

void set_obstacle(ContactStrip& strip, BeamCause cause, double forward_m, double near_m, double far_m) {
    strip.kind = BeamKind::Obstacle;
    strip.cause = cause;
    strip.contact_m = forward_m;
    strip.near_m = std::min(near_m, forward_m);
    strip.far_m = std::max(far_m, forward_m);
}

/// Votes and walls become obstacles; returns the contacts that later scans may confirm in memory.earlier.
void decide_obstacles(ContactMemory& memory, const Pose2& T_start_robot, const ContactParams& params,
                      ContactScan& out) {
    const std::size_t known = memory.earlier.size();  // places of this scan do not confirm each other
    for (int s = 0; s < static_cast<int>(out.strips.size()); ++s) {
        const StripEvidence& e = memory.evidence[static_cast<std::size_t>(s)];
        ContactStrip& strip = out.strips[static_cast<std::size_t>(s)];
        strip.score = e.votes.score;
        if (e.votes.score > params.score_min && e.votes.own > own_share * e.votes.score) {
            const double forward_m = smooth_m(memory.evidence, s);
            const Vector2d place_m = place_of(out, T_start_robot, s, forward_m);
            const bool before = was_seen_before(memory, known, place_m, forward_m);
            memory.earlier.push_back({place_m, memory.scans});
            if (before || e.votes.score > params.score_sure)
                set_obstacle(strip, BeamCause::Votes, forward_m, e.votes.near_m, e.votes.far_m);
        }
        if (e.wall_m > 0.0 && (strip.kind != BeamKind::Obstacle || e.wall_m < strip.contact_m))
            set_obstacle(strip, BeamCause::Wall, e.wall_m, 0.95 * e.wall_m, 1.05 * e.wall_m);
    }
}

/// Floor is free up to its end, and not beyond the contacts of this strip and its neighbours.
void decide_floor(const ContactMemory& memory, ContactScan& out) {
    const int strips = static_cast<int>(out.strips.size());
    for (int s = 0; s < strips; ++s) {
        ContactStrip& strip = out.strips[static_cast<std::size_t>(s)];
        double end_m = memory.evidence[static_cast<std::size_t>(s)].floor_end_m;
        for (int k = std::max(0, s - 1); k <= std::min(strips - 1, s + 1); ++k) {
            const ContactStrip& near = out.strips[static_cast<std::size_t>(k)];
            if (near.kind == BeamKind::Obstacle) end_m = std::min(end_m, near.near_m);
        }
        strip.seen = true;
        strip.free_m = end_m;
        if (strip.kind == BeamKind::Unknown && end_m > 0.0) strip.kind = BeamKind::Free;
    }
}

void begin_scan(const StripGrid& grid, const CameraMount& mount, ContactScan& out) {
    out.first = grid.first;
    out.step = strip_tangent;
    out.camera_m = {mount.forward_m, mount.left_m};
    out.T_robot_scan = {};
    out.floor = {};
    out.strips.assign(static_cast<std::size_t>(grid.strips), ContactStrip{});
}

FloorFit floor_fit(const PairMotion& measured, const PairMotion& fitted, const ContactMemory& memory) {
    FloorFit fit;
    fit.forward_m = fitted.forward_m - measured.forward_m;
    fit.omega_rad = fitted.omega_rad - measured.omega_rad;
    fit.pitch_rad = fitted.pitch_rad - measured.pitch_rad;
    fit.roll_rad = fitted.roll_rad;
    fit.tilt_pitch_rad = fitted.slope;
    fit.tilt_roll_rad = fitted.cross_slope;
    fit.fit_share = memory.comparison.fit_share;
    fit.vignetting = memory.vignetting;
    return fit;
}

void scan_pair(ContactMemory& memory, const CycleEnd& cycle, const ContactParams& params, ContactScan& out) {
    const KeyImage& reference = memory.keys[0];
    const KeyImage& newer = memory.keys[1];
    const StripGrid grid = strip_grid(newer.image);
    const PairMotion measured = pair_motion(reference, newer, cycle.mapper.camera().mount);
    PairPrior prior;
    prior.forward_m = std::max(way_error_min, cycle.way_error) * std::abs(measured.forward_m) + 1e-4;
    prior.right_m = 0.008 * std::abs(measured.forward_m) + 1e-4;
    const PairMotion motion =
        register_floor(reference.image, newer.image, measured, prior, memory.noise, memory.registration);
    const PairWarp warp = pair_warp(reference.image.camera, newer.image.camera, motion);
    compare_with_floor(reference.image, newer.image, warp, memory.noise, memory.comparison);
    out.floor = floor_fit(measured, motion, memory);
    vote_for_contacts(reference.image, newer.image, warp, memory.comparison, memory.noise, Voters::All,
                      {0, grid.strips}, memory.votes);
    gather_evidence(newer, grid, params, memory);
    ++memory.scans;
    forget_old(memory);
    decide_obstacles(memory, newer.T_start_robot, params, out);
    decide_floor(memory, out);
    out.gate = ContactGate::Open;
    learn(memory);
}

}  // namespace

PairMotion pair_motion(const KeyImage& reference, const KeyImage& newer, const CameraMount& mount) {
    const Pose2 T = compose(inverse(reference.T_start_robot), newer.T_start_robot);
    const double chord_m = std::hypot(T.x_m, T.y_m);
    const double chord_rad = chord_m > 0.0 ? wrap_angle(std::atan2(T.y_m, T.x_m) - T.yaw_rad / 2) : 0.0;
    const Vector2d travel = camera_travel(mount, chord_m, T.yaw_rad, chord_rad);
    PairMotion motion;
    motion.forward_m = travel.x();
    motion.right_m = -travel.y();
    motion.omega_rad = T.yaw_rad;
    motion.pitch_rad = newer.pitch_rad - reference.pitch_rad;
    return motion;
}

void restart(ContactMemory& memory, const RayMapper& mapper) {
    memory.mapping = LevelMapping(mapper);
    memory.keys_known = 0;
    memory.scans = 0;
    memory.earlier.clear();
}

bool scan_cycle(ContactMemory& memory, const CycleEnd& cycle, const ContactParams& params, ContactScan& out) {
    const bool has_reference = memory.keys_known > 0 && cycle.way_known;
    if (has_reference && way_m(memory.keys[0].T_start_robot, cycle.T_start_robot) < params.travel_m) {
        const double turn = cycle.T_start_robot.yaw_rad - memory.keys[0].T_start_robot.yaw_rad;
        if (std::abs(wrap_angle(turn)) < turn_max_rad) return false;
        memory.keys_known = 0;
    }
    KeyImage& newer = memory.keys[1];
    memory.mapping.apply(cycle.image, cycle.mapper, memory.vignetting, newer.image);
    newer.T_start_robot = cycle.T_start_robot;
    newer.pitch_rad = cycle.pitch_rad;
    begin_scan(strip_grid(newer.image), cycle.mapper.camera().mount, out);
    out.gate = ContactGate::NoTravel;
    if (has_reference && memory.keys_known > 0) scan_pair(memory, cycle, params, out);
    std::swap(memory.keys[0], memory.keys[1]);
    memory.keys_known = 1;
    return true;
}

}  // namespace flownav::obstacles
