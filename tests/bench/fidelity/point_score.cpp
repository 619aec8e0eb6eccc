#include "point_score.h"

#include <set>

#include "flownav/math/units.h"
#include "flownav/testing/truth.h"

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;
using sim::Solid;
using sim::World;

constexpr double view_half_angle_rad = 24.0 * degree_rad;
constexpr double hit_m = 0.25;
constexpr double low_m = 0.3;  // lower objects are not evaluated
constexpr int times_in_view = 3;
constexpr int hits_needed = 3;

Vector2d in_world(const Moment& m, const ObstaclePoint& point) {
    return transform(m.drive.scene.poses[static_cast<std::size_t>(m.image)], point.position_m.head<2>());
}

double distance_to_m(const World& world, const Vector2d& at_m, int object = 0) {
    double nearest_m = 9.0;
    for (const Solid& s : world.solids)
        if (object == 0 || s.object == object) nearest_m = std::min(nearest_m, testing::distance_m(s, at_m));
    return nearest_m;
}

World world_at(const Moment& m) {
    return testing::at_time(m.drive.scene.world, m.drive.scene.time_s(m.image));
}

struct Thing {
    Vector2d middle_m = Vector2d::Zero();
    double highest_m = 0.0;
    sim::ThingKind kind = sim::ThingKind::Box;
};

/// All objects except walls.
std::map<int, Thing> things_of(const World& world) {
    std::map<int, Thing> things;
    std::map<int, int> parts;
    for (const Solid& s : world.solids) {
        if (s.object == testing::wall_object) continue;
        const testing::Upright u = testing::upright_of(s);
        Thing& thing = things[s.object];
        thing.middle_m += u.centre_m;
        thing.highest_m = std::max(thing.highest_m, u.z_high_m);
        thing.kind = s.kind;
        ++parts[s.object];
    }
    for (auto& [object, thing] : things) thing.middle_m /= parts[object];
    return things;
}

bool ahead_between(const Moment& m, const Thing& thing, double nearest_m, double farthest_m) {
    const Pose2& robot = m.drive.scene.poses[static_cast<std::size_t>(m.image)];
    const Vector2d at = transform(inverse(robot), thing.middle_m);
    return at.norm() > nearest_m && at.norm() < farthest_m &&
           std::abs(std::atan2(at.y(), at.x())) < view_half_angle_rad;
}

std::set<int> objects_in_sight(const Moment& m) {
    std::set<int> objects;
    const sim::View view = testing::true_view(m.drive.scene, m.reference);
    for (const pipeline::BlockRecord& block : m.step.blocks) {
        const auto sight = testing::look(m.drive.scene.world, view, block.vector.at_px);
        if (sight) objects.insert(sight->object);
    }
    return objects;
}

}  // namespace

void PointScore::add(const PointScore& other) {
    ghosts.add(other.ghosts);
    near.add(other.near);
    for (std::size_t i = 0; i < surface_error_m.size(); ++i) {
        surface_error_m[i].insert(surface_error_m[i].end(), other.surface_error_m[i].begin(),
                                  other.surface_error_m[i].end());
    }
    objects.add(other.objects);
    chairs_in_a_cycle.add(other.chairs_in_a_cycle);
}

void PointWatcher::see(const Moment& m) {
    if (!m.step.end_of_cycle) return;
    see_chairs(m);
    if (m.step.obstacles.empty()) return;
    ++score_.ghosts.all;
    see_points(m);
    see_objects(m);
}

void PointWatcher::see_points(const Moment& m) {
    const World world = world_at(m);
    for (const ObstaclePoint& point : m.step.obstacles) {
        const double range_m = point.position_m.head<2>().norm();
        const double off_m = distance_to_m(world, in_world(m, point));
        score_.near.add(off_m <= 0.15 + 0.06 * range_m);
        score_.ghosts.hits += off_m > std::max(0.5, 0.15 * range_m) ? 1 : 0;
        if (range_m >= 1.0 && range_m < 4.0)
            score_.surface_error_m.at(static_cast<std::size_t>(range_m) - 1).push_back(off_m);
    }
}

void PointWatcher::see_objects(const Moment& m) {
    const World world = world_at(m);
    for (const auto& [object, thing] : things_of(world)) {
        if (thing.highest_m < low_m) continue;
        if (ahead_between(m, thing, 1.3, 3.5)) ++cycles_in_view_[object];
        for (const ObstaclePoint& point : m.step.obstacles)
            hits_[object] += distance_to_m(world, in_world(m, point), object) < hit_m ? 1 : 0;
    }
}

void PointWatcher::see_chairs(const Moment& m) {
    const World world = world_at(m);
    const auto things = things_of(world);
    std::set<int> in_sight;
    for (const auto& item : things) {
        const int object = item.first;
        const Thing& thing = item.second;
        if (thing.kind != sim::ThingKind::Chair || !ahead_between(m, thing, 2.0, 4.0)) continue;
        if (in_sight.empty()) in_sight = objects_in_sight(m);
        if (in_sight.count(object) == 0) continue;
        score_.chairs_in_a_cycle.add(
            std::any_of(m.step.obstacles.begin(), m.step.obstacles.end(), [&](const ObstaclePoint& point) {
                return distance_to_m(world, in_world(m, point), object) < hit_m;
            }));
    }
}

PointScore PointWatcher::result() const {
    PointScore score = score_;
    for (const auto& [object, cycles] : cycles_in_view_) {
        const auto hits = hits_.find(object);
        if (cycles >= times_in_view) score.objects.add(hits != hits_.end() && hits->second >= hits_needed);
    }
    return score;
}

}  // namespace flownav::fidelity
