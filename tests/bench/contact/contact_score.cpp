#include "contact_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "flownav/config/make_state.h"
#include "flownav/math/footprint.h"
#include "flownav/pipeline/pipeline.h"
#include "flownav/sim/lidar.h"

namespace flownav::contact_bench {
namespace {

using Eigen::Vector2d;

constexpr double near_m = 1.0;
constexpr double far_m = 3.0;
constexpr double hit_m = 0.2;
constexpr double view_tangent = 0.85;

struct Pass {
    int scans = 0;
    int gap = 0;
    bool detected = false;
};

double distance_to(const sim::Solid& solid, const Vector2d& at_m) {
    const Eigen::Vector3d local = solid.T_world_solid.inverse() * Eigen::Vector3d(at_m.x(), at_m.y(), 0.0);
    if (const auto* cylinder = std::get_if<sim::Cylinder>(&solid.shape))
        return std::abs(local.head<2>().norm() - cylinder->radius_m);
    const Vector2d half = std::get<sim::Box>(solid.shape).size_m.head<2>() / 2;
    return std::abs(
        signed_distance_m({-half, {half.x(), -half.y()}, half, {-half.x(), half.y()}}, local.head<2>()));
}

/// Surface that the horizontal ray of one bearing meets 4 cm above the floor.
struct Ray {
    double forward_m = std::numeric_limits<double>::infinity();
    Vector2d point_m = Vector2d::Zero();  ///< world
};

class Judge {
  public:
    Judge(const RecordedScene& scene, Score& score) : scene_(scene), score_(score) {
        lidar_.height_m = 0.04;
        lidar_.field_of_view_deg = 120.0;
        lidar_.beams = 961;
        lidar_.range_max_m = 8.0;
    }

    void field(const pipeline::Step& step, std::size_t image) {
        if (!step.new_contacts) return;
        const ContactScan& scan = step.contacts;
        score_.closed += scan.gate == ContactGate::PoorFloor;
        if (scan.gate != ContactGate::Open) return;
        ++score_.scans;
        score_.fit_share += scan.floor.fit_share;
        score_.vignetting += scan.floor.vignetting;
        // The scan speaks of the image with which it began.
        T_world_scan_ = compose(scene_.poses[image], scan.T_robot_scan);
        look_around(image);
        contacts_.clear();
        for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) strip(scan, i, image);
        for (const ObstaclePoint& p : step.obstacles)
            points_.push_back(transform(scene_.poses[image], p.position_m.head<2>()));
        things();
        points_.clear();
    }

    void finish() {
        for (auto& [object, pass] : passes_) end(pass);
    }

  private:
    void look_around(std::size_t image) {
        const VirtualScan seen = sim::scan(scene_.world, lidar_, T_world_scan_,
                                           scene_.fields[image].timestamp_s - sim::sim_start_s);
        rays_.assign(seen.beams.size(), Ray{});
        for (std::size_t i = 0; i < seen.beams.size(); ++i) {
            if (seen.beams[i].kind != BeamKind::Obstacle) continue;
            const double bearing = seen.first_bearing_rad + static_cast<double>(i) * seen.step_rad;
            const double range = seen.beams[i].range_m;
            rays_[i].forward_m = range * std::cos(bearing);
            rays_[i].point_m =
                transform(T_world_scan_, {range * std::cos(bearing), range * std::sin(bearing)});
        }
        first_rad_ = seen.first_bearing_rad;
        step_rad_ = seen.step_rad;
    }

    const Ray* ray_at(double right) const {
        const double i = std::round((std::atan(-right) - first_rad_) / step_rad_);
        return i < 0 || i >= static_cast<double>(rays_.size()) ? nullptr
                                                               : &rays_[static_cast<std::size_t>(i)];
    }

    double nearest_surface_m(const Vector2d& at_m) const {
        double nearest = 1e9;
        for (const Ray& ray : rays_)
            if (ray.forward_m < 1e9) nearest = std::min(nearest, (ray.point_m - at_m).norm());
        return nearest;
    }

    void strip(const ContactScan& scan, int i, std::size_t image) {
        const ContactStrip& s = scan.strips[static_cast<std::size_t>(i)];
        const double right = middle_tangent(scan, i);
        if (s.kind == BeamKind::Obstacle) {
            const Vector2d at_m = transform(scene_.poses[image], point_of(scan, right, s.contact_m));
            contacts_.push_back(at_m);
            const double off_m = nearest_surface_m(at_m);
            score_.false_strips += off_m > std::max(0.3, 0.12 * s.contact_m);
            score_.gross_strips += off_m > std::max(0.5, 0.25 * s.contact_m);
        }
        const Ray* const ray = ray_at(right);
        if (ray == nullptr) return;
        if (ray->forward_m < far_m && ray->forward_m > 0.6) {
            ++score_.facing;
            score_.wrong_free += s.free_m > 1.1 * ray->forward_m + 0.05;
            if (s.kind == BeamKind::Obstacle && ray->forward_m > near_m &&
                std::abs(s.contact_m / ray->forward_m - 1.0) < 0.4)
                score_.range_error.push_back(s.contact_m / ray->forward_m - 1.0);
        }
        if (std::abs(right) < std::tan(40.0 * M_PI / 180.0)) {
            ++score_.strips;
            score_.decided += s.free_m >= 2.0 || (s.kind == BeamKind::Obstacle && s.contact_m < 2.0);
        }
    }

    bool is_visible(const std::vector<const sim::Solid*>& solids) const {
        int rays = 0;
        for (const Ray& ray : rays_) {
            if (ray.forward_m > far_m || ray.forward_m < near_m) continue;
            for (const sim::Solid* solid : solids) rays += distance_to(*solid, ray.point_m) < 0.01;
        }
        return rays >= 12;
    }

    void things() {
        std::map<int, std::vector<const sim::Solid*>> objects;
        for (const sim::Solid& solid : scene_.world.solids) objects[solid.object].push_back(&solid);
        for (const auto& [object, solids] : objects) {
            const Vector2d middle =
                transform(inverse(T_world_scan_), solids[0]->T_world_solid.translation().head<2>());
            const bool in_view = scene_.options.things != Things::Mats && middle.x() > near_m &&
                                 std::abs(middle.y()) < view_tangent * middle.x() && middle.norm() < far_m &&
                                 is_visible(solids);
            Pass& pass = passes_[object];
            if (!in_view) {
                if (pass.scans > 0 && ++pass.gap > 4) end(pass);
                continue;
            }
            const auto near = [&, &on = solids](const Vector2d& p) {
                return std::any_of(on.begin(), on.end(),
                                   [&](const sim::Solid* s) { return distance_to(*s, p) < hit_m; });
            };
            const bool is_hit = std::any_of(contacts_.begin(), contacts_.end(), near);
            ++pass.scans;
            pass.gap = 0;
            pass.detected |= is_hit;
            ++score_.seen;
            score_.hit += is_hit;
            score_.points_hit += std::any_of(points_.begin(), points_.end(), near);
        }
    }

    void end(Pass& pass) {
        if (pass.scans >= 3) {
            ++score_.passes;
            score_.missed += !pass.detected;
        }
        pass = {};
    }

    const RecordedScene& scene_;
    Score& score_;
    sim::LidarParams lidar_;
    Pose2 T_world_scan_;
    std::vector<Ray> rays_;
    double first_rad_ = 0.0;
    double step_rad_ = 1.0;
    std::vector<Vector2d> contacts_;
    std::vector<Vector2d> points_;
    std::map<int, Pass> passes_;
};

/// Poses by wheels that measure 0.6 % too much of every way and 1 % too much of every turn.
std::vector<Pose2> wheels_of(const RecordedScene& scene) {
    std::vector<Pose2> wheels;
    Pose2 now;
    for (std::size_t i = 0; i < scene.poses.size(); ++i) {
        if (i > 0) {
            const Pose2 T = compose(inverse(scene.poses[i - 1]), scene.poses[i]);
            now = compose(now, {1.006 * T.x_m, 1.006 * T.y_m, 1.01 * T.yaw_rad});
        }
        wheels.push_back(now);
    }
    return wheels;
}

}  // namespace

void Score::add(const Score& o) {
    passes += o.passes;
    missed += o.missed;
    seen += o.seen;
    hit += o.hit;
    points_hit += o.points_hit;
    scans += o.scans;
    closed += o.closed;
    false_strips += o.false_strips;
    gross_strips += o.gross_strips;
    facing += o.facing;
    wrong_free += o.wrong_free;
    strips += o.strips;
    decided += o.decided;
    range_error.insert(range_error.end(), o.range_error.begin(), o.range_error.end());
    vignetting += o.vignetting;
    fit_share += o.fit_share;
}

Score evaluate(const RecordedScene& scene, const config::Config& config) {
    Score score;
    Judge judge(scene, score);
    pipeline::State state = config::make_state(config);
    const std::vector<Pose2> wheels = wheels_of(scene);
    for (std::size_t i = 0; i < scene.fields.size(); ++i) {
        pipeline::note_wheels(state, {scene.fields[i].timestamp_s, wheels[i]});
        judge.field(pipeline::step(state, scene.fields[i]), i);
    }
    judge.finish();
    return score;
}

}  // namespace flownav::contact_bench
