#include "flownav/obstacles/contact_scanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_decisions.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/obstacles/strip_grid.h"
#include "flownav/obstacles/strip_rules.h"
#include "scan_places.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

constexpr double learning_min = 0.1;  // weight of one scan for what is learnt
constexpr double vignetting_max = 0.6;
constexpr double vignetting_step = 0.01;  // images are corrected anew when it has changed so much
constexpr double noise_min = 0.4;
constexpr double noise_max = 6.0;
constexpr double turn_max_rad = 0.6;  // between the images of a scan
constexpr double in_view_m = 2.0;     // a strip is seen when its floor was compared nearer than this
constexpr double way_error_min = 0.015;
constexpr double way_error_max = 0.05;
constexpr double floor_preference_max = 0.4;  // of the costs above a contact
constexpr double informative_share = 0.0026;  // of all pixels: so many can tell whether the near floor is one

/// Keeps what the newest comparison tells about lens and noise.
void take_lesson(ContactMemory& memory) {
    memory.work.vignetting = memory.keys[0].image.vignetting + memory.comparison.vignetting;
    memory.work.noise = memory.comparison.noise;
}

/// Learns fall-off and noise: the first scan counts fully, later ones little.
void learn(ContactMemory& memory) {
    const ScanInWork& lesson = memory.work;
    const double gain = std::max(learning_min, 1.0 / (1.0 + memory.scans));
    memory.vignetting =
        std::clamp(memory.vignetting + gain * (lesson.vignetting - memory.vignetting), 0.0, vignetting_max);
    memory.noise = std::clamp(memory.noise + gain * (lesson.noise - memory.noise), noise_min, noise_max);
    const double change = std::abs(memory.vignetting - memory.keys[0].image.vignetting);
    if (memory.scans > 0 && change < vignetting_step) return;
    for (int i = 0; i < memory.keys.size(); ++i) take_out_vignetting(memory.keys[i].image, memory.vignetting);
}

/// True when floor of the strip was compared near the camera, and the strip shows an edge somewhere: what
/// shows none may be anything.
bool is_in_view(const LevelImage& image, const StripGrid& grid, const std::vector<FloorCell>& cells,
                int strip) {
    bool floor = false;
    bool edge = false;
    for (int cell = grid.cells - 1; cell >= 0 && !(floor && edge); --cell) {
        const FloorCell& c = cells[grid.index(cell, strip)];
        edge |= has_edge(c);
        const bool is_near = cell * cell_rows > grid.top_row && cell_floor_m(image.camera, cell) <= in_view_m;
        floor |= is_near && c.compared > 0;
    }
    return floor && edge;
}

void gather_evidence(const KeyImage& newer, const ContactParams& params, ContactMemory& memory) {
    const StripGrid grid = strip_grid(newer.image);
    memory.evidence.assign(static_cast<std::size_t>(grid.strips), StripEvidence{});
    for (int s = 0; s < grid.strips; ++s) {
        StripEvidence& strip = memory.evidence[static_cast<std::size_t>(s)];
        strip.votes = best_contact(newer.image, memory.votes.all, s, params.range_min_m, params.range_max_m);
        strip.is_seen = is_in_view(newer.image, grid, memory.comparison.cells, s);
    }
    find_floor_ends(newer.image, memory.comparison.cells, memory.floor, memory.evidence);
    find_walls(newer.image, memory.comparison.cells, memory.floor, params.range_max_m, memory.evidence);
}

void begin(const LevelImage& image, const CameraMount& mount, ContactScan& out) {
    const StripGrid grid = strip_grid(image);
    const int last_row = grid.cells * cell_rows - 1;
    out.view_near_m = image.camera.below_horizon(last_row) > 0.0 ? image.camera.floor_m(last_row)
                                                                 : std::numeric_limits<double>::infinity();
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

/// Registers the floor of the newest key image with that of key image `back`.
FittedPair fit_pair(ContactMemory& memory, int back) {
    const KeyImage& reference = memory.keys[back];
    const KeyImage& newer = memory.keys[0];
    FittedPair pair;
    pair.measured = pair_motion(reference, newer, memory.work.mount);
    PairPrior prior;
    prior.forward_m =
        std::clamp(memory.work.way_error, way_error_min, way_error_max) * std::abs(pair.measured.forward_m) +
        1e-4;
    prior.right_m = 0.008 * std::abs(pair.measured.forward_m) + 1e-4;
    pair.fitted =
        register_floor(reference.image, newer.image, pair.measured, prior, memory.noise, memory.registration);
    pair.warp = pair_warp(reference.image.camera, newer.image.camera, pair.fitted);
    return pair;
}

void register_pair(ContactMemory& memory) {
    choose_floor_pixels(memory.keys[0].image, memory.noise, memory.registration);
    memory.work.pair = fit_pair(memory, 1);
}

/// Compares the newest key image with that before it.
void compare_pair(ContactMemory& memory) {
    const LevelImage& newer = memory.keys[0].image;
    compare_with_floor(memory.keys[1].image, newer, memory.work.pair.warp, memory.noise,
                       {0, strip_grid(newer).strips}, memory.comparison);
    measure_preferences(memory.keys[1].image, newer, memory.work.pair.warp, memory.noise, memory.comparison);
    take_lesson(memory);
}

/// The first scan knows neither lens nor noise: compares twice.
void compare_first_pair(ContactMemory& memory) {
    compare_pair(memory);
    learn(memory);
    register_pair(memory);
    compare_pair(memory);
}

double turn_rad(const KeyImage& a, const KeyImage& b) {
    return std::abs(wrap_angle(a.T_start_robot.yaw_rad - b.T_start_robot.yaw_rad));
}

/// Index of the key image nearest to, but not under, the way of a long pair; 0: none.
int long_reference(const KeyImages& keys) {
    for (int i = 1; i < keys.size(); ++i)
        if (way_m(keys[i].T_start_robot, keys[0].T_start_robot) >= cone_travel_m)
            return turn_rad(keys[i], keys[0]) < turn_max_rad ? i : 0;
    return 0;
}

/// True unless most pixels of the near floor that could tell do not move as a floor does. Few pixels that
/// could tell are no objection, as long as floor is in view.
bool is_floor_believed(const ContactMemory& memory, const ContactParams& params) {
    const LevelImage& image = memory.keys[0].image;
    const double least = informative_share * image.width * image.height;
    const auto is_seen = [](const StripEvidence& strip) { return strip.is_seen; };
    if (std::none_of(memory.evidence.begin(), memory.evidence.end(), is_seen)) return false;
    return memory.comparison.near_informative < least || memory.comparison.fit_share >= params.fit_share_min;
}

/// Forgets contacts above which the image moves as floor does: a column without edges may be floor whose
/// texture is too weak for edges, and the floor beside a thing may get its votes.
void drop_contacts_on_floor(ContactMemory& memory) {
    const auto is_floor = [&](std::size_t strip, double forward_m) {
        const std::optional<double> preference =
            floor_preference(memory.keys[1].image, memory.keys[0].image, memory.work.pair.warp,
                             memory.comparison, memory.noise, static_cast<int>(strip), forward_m);
        return preference && *preference > floor_preference_max;
    };
    for (std::size_t s = 0; s < memory.evidence.size(); ++s) {
        StripEvidence& strip = memory.evidence[s];
        if (strip.votes.score > 0.0 && is_floor(s, strip.votes.forward_m)) strip.votes = {};
        if (strip.wall_m > 0.0 && is_floor(s, strip.wall_m)) strip.wall_m = 0.0;
    }
}

/// Decides about the strips by the votes of the short pair; false when the floor is not believed.
bool vote_of_pair(ContactMemory& memory, const ContactParams& params) {
    ContactScan& scan = memory.work.scan;
    const LevelImage& newer = memory.keys[0].image;
    scan.floor = floor_fit(memory.work.pair.measured, memory.work.pair.fitted, memory);
    vote_for_contacts(memory.keys[1].image, newer, memory.work.pair.warp, memory.comparison, memory.noise,
                      {0, strip_grid(newer).strips}, memory.votes);
    gather_evidence(memory.keys[0], params, memory);
    drop_contacts_on_floor(memory);
    if (!is_floor_believed(memory, params)) {
        scan.gate = ContactGate::PoorFloor;
        memory.earlier.clear();
        forget_pairs(memory.cone);
        return false;
    }
    ++memory.scans;
    scan.gate = ContactGate::Open;
    decide_obstacles(memory, params, scan);
    return true;
}

/// Compares the newest key image with one half a metre back, for the strips straight ahead.
void compare_ahead(ContactMemory& memory) {
    memory.work.ahead = long_reference(memory.keys);
    if (memory.work.ahead == 0) return;
    const LevelImage& newer = memory.keys[0].image;
    const StripGrid grid = strip_grid(newer);
    memory.work.pair = fit_pair(memory, memory.work.ahead);
    compare_with_floor(memory.keys[memory.work.ahead].image, newer, memory.work.pair.warp, memory.noise,
                       side_strips(grid.first, grid.strips), memory.comparison);
}

void vote_ahead(ContactMemory& memory) {
    if (memory.work.ahead == 0) return;
    const KeyImage& newer = memory.keys[0];
    const StripGrid grid = strip_grid(newer.image);
    vote_for_contacts(memory.keys[memory.work.ahead].image, newer.image, memory.work.pair.warp,
                      memory.comparison, memory.noise, side_strips(grid.first, grid.strips), memory.votes);
    take_votes(newer.image, memory.votes, memory.cone.sides,
               push_cone_votes(memory.cone, newer.T_start_robot));
}

void finish_scan(ContactMemory& memory, const ContactParams& params) {
    ContactScan& scan = memory.work.scan;
    decide_cone(memory.cone, memory.keys[0].T_start_robot, memory.work.ahead != 0, params.range_max_m, scan);
    fill_holes(scan);
    decide_floor(memory, scan);
    learn(memory);
}

/// Room for the largest scan of a camera, so that no scan allocates.
void reserve(ContactMemory& memory, const CameraModel& camera) {
    const auto half = [](int px) { return static_cast<std::size_t>(px / 2); };
    const std::size_t pixels = half(camera.width_px) * half(camera.height_px);
    memory.keys.reserve(pixels);
    reserve(memory.comparison, half(camera.width_px), half(camera.height_px));
    reserve(memory.votes, half(camera.height_px));
    memory.evidence.reserve(strips_max);
    memory.floor.floor.reserve(strips_max * (half(camera.height_px) / cell_rows + 1));
    memory.floor.ends.reserve(strips_max);
    memory.floor.sorted.reserve(strips_max);
    memory.floor.missing.reserve(half(camera.height_px) / cell_rows + 1);
    reserve(memory.registration, pixels);
    memory.earlier.reserve(2048);
    memory.work.scan.strips.reserve(strips_max);
    reserve(memory.cone, half(camera.height_px) / cell_rows);
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
    memory.scans = 0;
    memory.noise = ContactMemory{}.noise;
    memory.vignetting = 0.0;
    forget_images(memory);
    reserve(memory, mapper.camera());
}

void forget_images(ContactMemory& memory) {
    memory.work.next = ScanPart::None;
    memory.keys.keep(0);
    memory.earlier.clear();
    forget_pairs(memory.cone);
}

bool begin_scan(ContactMemory& memory, const CycleEnd& cycle, const ContactParams& params) {
    if (!cycle.way_known) forget_images(memory);
    if (memory.keys.size() > 0) {
        const Pose2& before = memory.keys[0].T_start_robot;
        const double turn = std::abs(wrap_angle(cycle.T_start_robot.yaw_rad - before.yaw_rad));
        if (turn < turn_max_rad && way_m(before, cycle.T_start_robot) < params.travel_m) return false;
        if (turn >= turn_max_rad) forget_images(memory);
    }
    KeyImage& newer = memory.keys.push();
    memory.mapping.apply(cycle.image, cycle.mapper, newer.image);
    take_out_vignetting(newer.image,
                        memory.keys.size() > 1 ? memory.keys[1].image.vignetting : memory.vignetting);
    newer.T_start_robot = cycle.T_start_robot;
    newer.pitch_rad = cycle.pitch_rad;
    memory.work.way_error = cycle.way_error;
    memory.work.mount = cycle.mapper.camera().mount;
    begin(newer.image, memory.work.mount, memory.work.scan);
    memory.work.scan.gate = ContactGate::NoTravel;
    memory.work.next = ScanPart::Register;
    return true;
}

bool is_scanning(const ContactMemory& memory) {
    return memory.work.next != ScanPart::None;
}

bool continue_scan(ContactMemory& memory, const ContactParams& params, ContactScan& out) {
    const ScanPart part = memory.work.next;
    memory.work.next = ScanPart::None;
    switch (part) {
        case ScanPart::None:
            return false;
        case ScanPart::Register:
            if (memory.keys.size() < 2) break;
            register_pair(memory);
            memory.work.next = ScanPart::Compare;
            return false;
        case ScanPart::Compare:
            memory.scans == 0 ? compare_first_pair(memory) : compare_pair(memory);
            memory.work.next = ScanPart::Vote;
            return false;
        case ScanPart::Vote:
            if (!vote_of_pair(memory, params)) break;
            memory.work.next = ScanPart::CompareAhead;
            return false;
        case ScanPart::CompareAhead:
            compare_ahead(memory);
            memory.work.next = ScanPart::VoteAhead;
            return false;
        case ScanPart::VoteAhead:
            vote_ahead(memory);
            finish_scan(memory, params);
            break;
    }
    out = memory.work.scan;
    return true;
}

bool scan_cycle(ContactMemory& memory, const CycleEnd& cycle, const ContactParams& params, ContactScan& out) {
    if (!begin_scan(memory, cycle, params)) return false;
    while (!continue_scan(memory, params, out)) {
    }
    return true;
}

}  // namespace flownav::obstacles
