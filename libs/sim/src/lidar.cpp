#include "flownav/sim/lidar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "flownav/core/plane_geometry.h"
#include "flownav/math/units.h"
#include "flownav/sim/ground.h"
#include "flownav/sim/plan_view.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;

constexpr double never_m = std::numeric_limits<double>::infinity();

double range_m(const Disc& disc, const Vector2d& from, const Vector2d& direction) {
    const Vector2d to_centre = disc.centre_m - from;
    const double along_m = to_centre.dot(direction);
    const double inside2 = disc.radius_m * disc.radius_m - to_centre.squaredNorm();
    if (inside2 >= 0.0) return 0.0;
    const double half2 = inside2 + along_m * along_m;
    return along_m > 0.0 && half2 >= 0.0 ? along_m - std::sqrt(half2) : never_m;
}

double range_m(const Polygon& polygon, const Vector2d& from, const Vector2d& direction) {
    if (signed_distance_m(polygon, from) <= 0.0) return 0.0;
    double range_m = never_m;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vector2d edge = polygon[i] - polygon[j];
        const double slope = cross(direction, edge);
        if (slope == 0.0) continue;
        const double along_m = cross(polygon[j] - from, edge) / slope;
        const double share = cross(polygon[j] - from, direction) / slope;
        if (along_m >= 0.0 && share >= 0.0 && share <= 1.0) range_m = std::min(range_m, along_m);
    }
    return range_m;
}

void check(const LidarParams& p) {
    if (p.beams < 2 || !(p.range_max_m > 0.0) ||
        !(p.field_of_view_deg > 0.0 && p.field_of_view_deg <= 360.0)) {
        throw std::invalid_argument(
            "a lidar needs at least 2 beams, a range above 0 and a field of view of at most 360 degrees");
    }
}

/// The beams of one scan, and their directions in the world.
class Beams {
  public:
    Beams(VirtualScan& scan, const Pose2& T_world_lidar, double range_max_m)
        : scan_(scan),
          from_(T_world_lidar.x_m, T_world_lidar.y_m),
          yaw_rad_(T_world_lidar.yaw_rad),
          range_max_m_(range_max_m) {
        for (std::size_t i = 0; i < scan.beams.size(); ++i) {
            const double angle_rad =
                yaw_rad_ + scan.first_bearing_rad + static_cast<double>(i) * scan.step_rad;
            directions_.emplace_back(std::cos(angle_rad), std::sin(angle_rad));
        }
    }

    /// Writes a solid within `around_m` of `centre_m` into the beams that can meet it.
    void see(const PlanShape& shape, const Vector2d& centre_m, double around_m) {
        const Vector2d to = centre_m - from_;
        const double distance_m = to.norm();
        if (distance_m - around_m > range_max_m_) return;
        if (distance_m <= around_m) return see(shape, 0, static_cast<int>(directions_.size()) - 1);
        const double half_rad = std::asin(around_m / distance_m) + 1e-9;
        const double bearing_rad = wrap_angle(std::atan2(to.y(), to.x()) - yaw_rad_);
        for (const double turn_rad : {-2.0 * M_PI, 0.0, 2.0 * M_PI}) {
            const double first =
                (bearing_rad + turn_rad - half_rad - scan_.first_bearing_rad) / scan_.step_rad;
            const double last =
                (bearing_rad + turn_rad + half_rad - scan_.first_bearing_rad) / scan_.step_rad;
            see(shape, static_cast<int>(std::ceil(first)), static_cast<int>(std::floor(last)));
        }
    }

  private:
    void see(const PlanShape& shape, int first, int last) {
        last = std::min(last, static_cast<int>(directions_.size()) - 1);
        for (int i = std::max(first, 0); i <= last; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const double found_m =
                std::visit([&](const auto& s) { return range_m(s, from_, directions_[k]); }, shape);
            if (found_m <= scan_.beams[k].range_m) scan_.beams[k] = {BeamKind::Obstacle, found_m};
        }
    }

    VirtualScan& scan_;
    Vector2d from_;
    double yaw_rad_;
    double range_max_m_;
    std::vector<Vector2d> directions_;
};

/// Writes the walls of the ground that reach through the plane into the beams, as plates of a millimetre.
void see_ground(const World& world, double plane_m, Beams& beams) {
    constexpr double plate_m = 0.001;
    if (world.ground.empty()) return;
    for (const GroundWall& wall : ground_walls(world)) {
        const double low_m = std::min(wall.left_m.z(), wall.right_m.z());
        const double high_m =
            std::max(wall.left_m.z() + wall.left_rise_m, wall.right_m.z() + wall.right_rise_m);
        if (plane_m < low_m || plane_m > high_m) continue;
        const Vector2d left = wall.left_m.head<2>();
        const Vector2d right = wall.right_m.head<2>();
        const Vector2d along = (right - left).normalized();
        const Vector2d behind = plate_m * Vector2d(-along.y(), along.x());
        const Vector2d middle = (left + right) / 2;
        beams.see(Polygon{left, right, right + behind, left + behind}, middle,
                  (right - left).norm() / 2 + plate_m);
    }
}

}  // namespace

VirtualScan scan(const World& world, const LidarParams& params, const Pose2& T_world_robot, double time_s) {
    check(params);
    const double view_rad = params.field_of_view_deg * degree_rad;
    VirtualScan scan;
    // A full turn has no two beams in the same direction.
    const int gaps = params.field_of_view_deg < 360.0 ? params.beams - 1 : params.beams;
    scan.step_rad = view_rad / gaps;
    scan.first_bearing_rad = -scan.step_rad * (params.beams - 1) / 2;
    scan.beams.assign(static_cast<std::size_t>(params.beams), {BeamKind::Free, params.range_max_m});
    Beams beams(scan, T_world_robot, params.range_max_m);
    const Vector2d axis_m(T_world_robot.x_m, T_world_robot.y_m);
    const double plane_m = params.height_m + (world.ground.empty() ? 0.0 : ground_height_m(world, axis_m));
    for (const Solid& solid : world.solids) {
        if (!solid.solid) continue;
        const Eigen::Isometry3d pose = pose_at(solid, time_s);
        const auto shape = plan_view(solid.shape, pose, plane_m, plane_m);
        if (!shape) continue;
        beams.see(*shape, pose.translation().head<2>(), bounding_radius_m(solid.shape));
    }
    see_ground(world, plane_m, beams);
    return scan;
}

}  // namespace flownav::sim
