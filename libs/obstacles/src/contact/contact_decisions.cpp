#include "contact_decisions.h"

#include <algorithm>
#include <cmath>

#include "scan_places.h"
#include "set_obstacle.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

constexpr double own_share = 0.15;   // of the votes of three strips: those of the middle one
constexpr double sure_from_m = 1.0;  // nearer, no contact is believed that was not seen before
constexpr int confirming_scans = 2;  // so many scans back
// A wall farther away than near_wall_m must have been seen before from so far back: where floor loses its
// texture, its end moves on with the robot.
constexpr double near_wall_m = 1.0;
constexpr double wall_way_min_m = 0.25;
constexpr double remembered_way_m = 0.9;
constexpr double same_place_m = 0.2;
constexpr double same_place_share = 0.12;  // of the distance
constexpr double flat_surface = 0.12;      // largest relative step of range between the ends of one surface
constexpr int hole_strips = 2;             // most strips inside a surface without votes
constexpr double one_surface = 0.3;        // largest relative step of range between strips of one surface

/// True when one of the first `count` earlier contacts that `counts(contact)` was at this place.
template <class Counts>
bool was_seen_before(const ContactMemory& memory, std::size_t count, const Vector2d& place_m,
                     double forward_m, const Counts& counts) {
    const double tolerance_m = std::max(same_place_m, same_place_share * forward_m);
    return std::any_of(
        memory.earlier.begin(), memory.earlier.begin() + static_cast<std::ptrdiff_t>(count),
        [&](const EarlierContact& c) { return (c.place_m - place_m).norm() < tolerance_m && counts(c); });
}

Vector2d robot_of(const ContactMemory& memory) {
    return {memory.keys[0].T_start_robot.x_m, memory.keys[0].T_start_robot.y_m};
}

void forget_old(ContactMemory& memory) {
    const Vector2d robot_m = robot_of(memory);
    const auto is_old = [&](const EarlierContact& c) {
        return c.scan < memory.scans - confirming_scans && (c.robot_m - robot_m).norm() > remembered_way_m;
    };
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

/// What earlier scans say about contacts of the newest one.
struct Earlier {
    ContactMemory& memory;
    const std::size_t known;  ///< contacts of earlier scans; places of one scan do not confirm each other

    bool voted(const Vector2d& place_m, double forward_m) const {
        return was_seen_before(memory, known, place_m, forward_m, [&](const EarlierContact& c) {
            return c.scan >= memory.scans - confirming_scans;
        });
    }
    bool showed_wall(const Vector2d& place_m, double forward_m) const {
        const Vector2d robot_m = robot_of(memory);
        return was_seen_before(memory, known, place_m, forward_m, [&](const EarlierContact& c) {
            return (c.robot_m - robot_m).norm() >= wall_way_min_m;
        });
    }
    void note(const Vector2d& place_m) const {
        memory.earlier.push_back({place_m, robot_of(memory), memory.scans});
    }
};

}  // namespace

void decide_obstacles(ContactMemory& memory, const ContactParams& params, ContactScan& out) {
    forget_old(memory);
    const Pose2& T_start_robot = memory.keys[0].T_start_robot;
    const Earlier earlier{memory, memory.earlier.size()};
    for (int s = 0; s < static_cast<int>(out.strips.size()); ++s) {
        const StripEvidence& e = memory.evidence[static_cast<std::size_t>(s)];
        ContactStrip& strip = out.strips[static_cast<std::size_t>(s)];
        const auto place_at = [&](double forward_m) {
            return place_of(out, T_start_robot, forward_m, middle_tangent(out, s));
        };
        strip.score = e.votes.score;
        if (e.votes.score > params.score_min && e.votes.own > own_share * e.votes.score) {
            const double forward_m = smooth_m(memory.evidence, s);
            const bool before = earlier.voted(place_at(forward_m), forward_m);
            earlier.note(place_at(forward_m));
            const bool is_sure = e.votes.score > params.score_sure && forward_m > sure_from_m;
            if (before || is_sure)
                set_obstacle(strip, BeamCause::Votes, forward_m, e.votes.near_m, e.votes.far_m);
        }
        if (e.wall_m > 0.0) {
            const bool before = earlier.showed_wall(place_at(e.wall_m), e.wall_m);
            earlier.note(place_at(e.wall_m));
            const bool is_nearest = strip.kind != BeamKind::Obstacle || e.wall_m < strip.contact_m;
            if ((before || e.wall_m < near_wall_m) && is_nearest)
                set_obstacle(strip, BeamCause::Wall, e.wall_m, 0.95 * e.wall_m, 1.05 * e.wall_m);
        }
    }
}

void fill_holes(ContactScan& out) {
    const int strips = static_cast<int>(out.strips.size());
    const auto at = [&](int s) -> ContactStrip& { return out.strips[static_cast<std::size_t>(s)]; };
    for (int s = 0; s + 2 < strips; ++s) {
        if (at(s).kind != BeamKind::Obstacle || at(s + 1).kind == BeamKind::Obstacle) continue;
        for (int end = s + 2; end <= std::min(s + hole_strips + 1, strips - 1); ++end) {
            if (at(end).kind != BeamKind::Obstacle) continue;
            const double near_m = std::min(at(s).contact_m, at(end).contact_m);
            if (std::abs(at(s).contact_m - at(end).contact_m) > flat_surface * near_m) break;
            for (int k = s + 1; k < end; ++k) {
                const double share = static_cast<double>(k - s) / (end - s);
                const double forward_m = at(s).contact_m + share * (at(end).contact_m - at(s).contact_m);
                set_obstacle(at(k), at(s).cause, forward_m, std::min(at(s).near_m, at(end).near_m),
                             std::max(at(s).far_m, at(end).far_m));
            }
            break;
        }
    }
}

void decide_floor(const ContactMemory& memory, ContactScan& out) {
    const int strips = static_cast<int>(out.strips.size());
    for (int s = 0; s < strips; ++s) {
        ContactStrip& strip = out.strips[static_cast<std::size_t>(s)];
        double end_m = memory.evidence[static_cast<std::size_t>(s)].floor_end_m;
        for (int k = std::max(0, s - 1); k <= std::min(strips - 1, s + 1); ++k) {
            const ContactStrip& near = out.strips[static_cast<std::size_t>(k)];
            if (near.kind == BeamKind::Obstacle) end_m = std::min(end_m, near.near_m);
        }
        strip.seen = memory.evidence[static_cast<std::size_t>(s)].is_seen;
        strip.free_m = end_m;
        if (strip.kind == BeamKind::Unknown && end_m > 0.0) strip.kind = BeamKind::Free;
    }
}

}  // namespace flownav::obstacles
