#include "flownav/obstacles/cone_scan.h"

#include <algorithm>
#include <cmath>

#include "flownav/obstacles/strip_grid.h"
#include "scan_places.h"
#include "set_obstacle.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

constexpr int cone_strips = 8;             // of the cone, and one more on either side
constexpr double side_tangent_min = 0.15;  // of the strips at the sides
constexpr double side_tangent_max = 0.6;
constexpr double usual_percentile = 0.3;
constexpr double accumulated_m = 0.7;  // way over which votes are added up
constexpr int pairs_min = 3;
constexpr float score_limit = 160.0F;  // of one pair
constexpr double nearest_m = 1.3;      // long pairs cannot place a contact that is nearer
constexpr double farthest_m = 4.5;
constexpr double held_below_m = 1.45;  // nearer: the held place is the answer
constexpr double held_way_m = 1.2;     // a place is held over this way
constexpr double same_place = 0.25;    // of the distance, between two scans
constexpr double plateau_share = 0.85;
constexpr double steep_min = 14.0;   // score of steep edges that is an alarm
constexpr double steep_ratio = 8.0;  // and its ratio to that of the sides,
constexpr double steep_usual_min = 0.8;
constexpr double all_min = 30.0;  // the same of all edges
constexpr double all_ratio = 11.0;
constexpr double all_usual_min = 2.0;

bool is_in_cone(double right) {
    return std::abs(right) < cone_tangent;
}

const ConeVotes& nth(const ConeMemory& memory, int i) {
    return memory.votes[static_cast<std::size_t>((memory.newest + i) % ConeMemory::most)];
}

/// Best score of a pair near a place, given in the camera's frame of that pair.
float best_near(const ConeVotes& pair, const std::vector<float>& score, double forward_m, double right_m) {
    const double along_m = std::max(0.12, 0.08 * forward_m);
    const double across_m = std::max(0.1, 0.05 * forward_m);
    float best = 0.0F;
    for (std::size_t c = 0; c < pair.forward_m.size(); ++c) {
        if (std::abs(pair.forward_m[c] - forward_m) > along_m) continue;
        for (int s = 0; s < pair.strips; ++s) {
            const double right = (pair.first + s + 0.5) * strip_tangent;
            if (std::abs(right * pair.forward_m[c] - right_m) > across_m) continue;
            best = std::max(best,
                            score[c * static_cast<std::size_t>(pair.strips) + static_cast<std::size_t>(s)]);
        }
    }
    return best;
}

/// Sums over the pairs of the last part of the way.
struct Accumulated {
    int pairs = 0;
    double steep_usual = 0.0;
    double all_usual = 0.0;
};

/// The best candidate of the cone.
struct Best {
    double score = 0.0;  ///< ratio to its threshold
    double forward_m = 0.0;
    double near_m = 0.0;
    double far_m = 0.0;
    double right = 0.0;
};

Accumulated count_pairs(const ConeMemory& memory) {
    Accumulated sum;
    for (int i = 0; i < memory.size; ++i) {
        const ConeVotes& pair = nth(memory, i);
        if (way_m(pair.T_start_robot, nth(memory, 0).T_start_robot) > accumulated_m) break;
        sum.steep_usual += pair.steep.usual;
        sum.all_usual += pair.all.usual;
        ++sum.pairs;
    }
    if (sum.pairs > 0) {
        sum.steep_usual /= sum.pairs;
        sum.all_usual /= sum.pairs;
    }
    return sum;
}

/// Mean score of a place over the pairs, as ratio to what is an alarm.
double alarm_ratio(const ConeMemory& memory, const Accumulated& sum, const ContactScan& scan,
                   const Vector2d& place_m) {
    double steep = 0.0;
    double all = 0.0;
    for (int i = 0; i < sum.pairs; ++i) {
        const ConeVotes& pair = nth(memory, i);
        const Vector2d at = seen_from(scan, pair.T_start_robot, place_m);
        steep += std::min(score_limit, best_near(pair, pair.steep.score, at.x(), at.y()));
        all += std::min(score_limit, best_near(pair, pair.all.score, at.x(), at.y()));
    }
    const double steep_limit = std::max(steep_min, steep_ratio * std::max(sum.steep_usual, steep_usual_min));
    const double all_limit = std::max(all_min, all_ratio * std::max(sum.all_usual, all_usual_min));
    return std::max(steep / sum.pairs / steep_limit, all / sum.pairs / all_limit);
}

Best find_best(const ConeMemory& memory, const Accumulated& sum, const ContactScan& scan,
               std::vector<float>& sums) {
    const ConeVotes& newest = nth(memory, 0);
    const std::size_t cells = newest.forward_m.size();
    sums.assign(cells, 0.0F);
    Best best;
    std::size_t best_cell = 0;
    for (std::size_t c = 0; c < cells; ++c) {
        const double forward_m = newest.forward_m[c];
        if (forward_m < nearest_m || forward_m > farthest_m) continue;
        for (int s = 0; s < newest.strips; ++s) {
            const double right = (newest.first + s + 0.5) * strip_tangent;
            if (!is_in_cone(right)) continue;
            const double ratio =
                alarm_ratio(memory, sum, scan, place_of(scan, newest.T_start_robot, forward_m, right));
            sums[c] = std::max(sums[c], static_cast<float>(ratio));
            if (ratio <= best.score) continue;
            best.score = ratio;
            best.right = right;
            best_cell = c;
        }
    }
    if (best.score <= 0.0) return best;
    std::size_t near = best_cell;
    std::size_t far = best_cell;
    const auto in_plateau = [&](std::size_t c) { return sums[c] > plateau_share * best.score; };
    while (near > 0 && in_plateau(near - 1)) --near;
    while (far + 1 < cells && in_plateau(far + 1)) ++far;
    best.near_m = newest.forward_m[near];
    best.far_m = newest.forward_m[far];
    best.forward_m = 2.0 / (1.0 / best.near_m + 1.0 / best.far_m);
    return best;
}

/// True while a thing is in the cone, or a strip beside it.
bool is_ahead(const HeldThing& thing, const Pose2& T_start_robot, const ContactScan& scan) {
    const Vector2d at = seen_from(scan, T_start_robot, thing.place_m);
    return std::abs(at.y()) < (cone_tangent + strip_tangent) * at.x();
}

/// Enters a thing into the strips of the cone that it covers.
void enter(const HeldThing& thing, const Pose2& T_start_robot, double range_max_m, ContactScan& out) {
    const Vector2d at = seen_from(out, T_start_robot, thing.place_m);
    const double forward_m = at.x();
    if (forward_m <= 0.2 || forward_m > range_max_m) return;
    const double right = at.y() / forward_m;
    const double half = std::max(0.08 / forward_m, 0.5 * strip_tangent);
    for (int i = 0; i < static_cast<int>(out.strips.size()); ++i) {
        const double middle = middle_tangent(out, i);
        if (std::abs(middle - right) > half + 0.5 * strip_tangent - 1e-6) continue;
        ContactStrip& strip = out.strips[static_cast<std::size_t>(i)];
        const bool is_nearer = strip.kind == BeamKind::Obstacle && strip.contact_m < forward_m;
        if (is_nearer && (strip.cause != BeamCause::Votes || forward_m >= held_below_m)) continue;
        set_obstacle(strip, BeamCause::Votes, forward_m, std::max(0.1, forward_m - thing.near_m),
                     forward_m + thing.far_m);
    }
}

/// Best score of one strip in the range of the long pairs.
float best_of_strip(const LevelImage& newer, const StripGrid& grid, const std::vector<float>& votes,
                    int strip) {
    float best = 0.0F;
    for (int cell = grid.cells - 1; cell * cell_rows > grid.top_row; --cell) {
        const double forward_m = cell_floor_m(newer.camera, cell);
        if (forward_m > farthest_m) break;
        if (forward_m >= nearest_m) best = std::max(best, contact_score(grid, votes, cell, strip));
    }
    return best;
}

/// Copies the scores of the cone and measures those of the strips at its sides.
void take_part(const LevelImage& newer, const std::vector<float>& votes, std::vector<float>& sides,
               const ConeVotes& cone, ConeVotes::Part& part) {
    const StripGrid grid = strip_grid(newer);
    part.score.clear();
    for (int i = 0; i < static_cast<int>(cone.forward_m.size()); ++i) {
        for (int s = 0; s < cone.strips; ++s)
            part.score.push_back(contact_score(grid, votes, grid.cells - 1 - i, cone.first + s - grid.first));
    }
    sides.clear();
    for (int s = 0; s < grid.strips; ++s) {
        const double right = std::abs((grid.first + s + 0.5) * strip_tangent);
        if (right >= side_tangent_min && right <= side_tangent_max)
            sides.push_back(best_of_strip(newer, grid, votes, s));
    }
    part.usual = 0.0;
    if (sides.empty()) return;
    const auto at =
        sides.begin() + static_cast<std::ptrdiff_t>(usual_percentile * static_cast<double>(sides.size() - 1));
    std::nth_element(sides.begin(), at, sides.end());
    part.usual = *at;
}

/// Holds what stands out of the votes of the newest pair and those before it, in two scans at one place.
void look_for_thing(ConeMemory& memory, const Pose2& T_start_robot, const ContactScan& scan) {
    const Accumulated sum = count_pairs(memory);
    std::optional<HeldThing> now;
    if (sum.pairs >= pairs_min) {
        const Best best = find_best(memory, sum, scan, memory.sums);
        if (best.score > 1.0)
            now = HeldThing{place_of(scan, T_start_robot, best.forward_m, best.right),
                            best.forward_m - best.near_m, best.far_m - best.forward_m, T_start_robot};
    }
    if (now && memory.candidate) {
        const double forward_m = seen_from(scan, T_start_robot, now->place_m).x();
        if ((now->place_m - memory.candidate->place_m).norm() < same_place * forward_m) memory.held = now;
    }
    memory.candidate = now;
}

}  // namespace

StripRange side_strips(int first, int strips) {
    const int from = static_cast<int>(std::floor(-side_tangent_max / strip_tangent)) - first - 1;
    const int to = static_cast<int>(std::ceil(side_tangent_max / strip_tangent)) - first + 1;
    return {std::max(0, from), std::min(strips, to)};
}

ConeVotes& push_cone_votes(ConeMemory& memory, const Pose2& T_start_robot) {
    memory.newest = (memory.newest + ConeMemory::most - 1) % ConeMemory::most;
    memory.size = std::min(memory.size + 1, ConeMemory::most);
    ConeVotes& votes = memory.votes[static_cast<std::size_t>(memory.newest)];
    votes.T_start_robot = T_start_robot;
    return votes;
}

void forget_pairs(ConeMemory& memory) {
    memory.size = 0;
    memory.candidate.reset();
    memory.held.reset();
}

void reserve(ConeMemory& memory, std::size_t cells) {
    const auto strips = static_cast<std::size_t>(cone_strips);
    for (ConeVotes& pair : memory.votes) {
        pair.forward_m.reserve(cells);
        pair.steep.score.reserve(cells * strips);
        pair.all.score.reserve(cells * strips);
    }
    memory.sums.reserve(cells);
    memory.sides.reserve(64);
}

void take_votes(const LevelImage& newer, const ContactVotes& votes, std::vector<float>& sides,
                ConeVotes& out) {
    const StripGrid grid = strip_grid(newer);
    out.first = -cone_strips / 2;
    out.strips = cone_strips;
    out.forward_m.clear();
    for (int cell = grid.cells - 1; cell * cell_rows > grid.top_row; --cell) {
        const double forward_m = cell_floor_m(newer.camera, cell);
        if (forward_m > farthest_m + 1.0) break;
        out.forward_m.push_back(forward_m);
    }
    take_part(newer, votes.all, sides, out, out.all);
    take_part(newer, votes.steep, sides, out, out.steep);
}

void decide_cone(ConeMemory& memory, const Pose2& T_start_robot, bool has_new_pair, double range_max_m,
                 ContactScan& out) {
    if (has_new_pair) look_for_thing(memory, T_start_robot, out);
    if (memory.held && (way_m(memory.held->seen_from, T_start_robot) > held_way_m ||
                        !is_ahead(*memory.held, T_start_robot, out)))
        memory.held.reset();
    if (memory.held) enter(*memory.held, T_start_robot, range_max_m, out);
}

}  // namespace flownav::obstacles
