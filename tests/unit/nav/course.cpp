#include "course.h"

#include <algorithm>
#include <cmath>

#include "flownav/sim/collision.h"
#include "flownav/sim/vehicle.h"

namespace flownav::nav {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

void Course::add_wall(const Vector2d& a_m, const Vector2d& b_m) {
    const int steps = static_cast<int>(std::ceil((b_m - a_m).norm() / 0.1));
    for (int i = 0; i <= steps; ++i) posts.push_back({a_m + (b_m - a_m) * i / std::max(1, steps), 0.075});
}

COccupancyGridMap2D Course::local_map(const Pose2& T_map_robot) const {
    const auto half = static_cast<float>(size_m / 2);
    COccupancyGridMap2D map(-half, half, -half, half, static_cast<float>(cell_m));
    map.fill(p_elsewhere);
    const Pose2 T_robot_map = inverse(T_map_robot);
    for (const Post& post : posts) {
        const Vector2d middle = transform(T_robot_map, post.at_m);
        const double reach_m = post.radius_m + cell_m;
        for (double y = middle.y() - reach_m; y <= middle.y() + reach_m; y += cell_m / 2) {
            for (double x = middle.x() - reach_m; x <= middle.x() + reach_m; x += cell_m / 2) {
                const int column = map.x2idx(x);
                const int row = map.y2idx(y);
                if (std::max(std::abs(x), std::abs(y)) >= half) continue;
                // Marks every cell that the post covers at least in part, approximately.
                const Vector2d cell(map.idx2x(column), map.idx2y(row));
                if ((cell - middle).norm() < post.radius_m + 0.4 * cell_m) map.setCell(column, row, 0.1F);
            }
        }
    }
    return map;
}

sim::World Course::world() const {
    sim::World world;
    for (const Post& post : posts) {
        sim::Solid solid;
        solid.shape = sim::Cylinder{post.radius_m, 1.0};
        solid.T_world_solid.translation() << post.at_m, 0.5;
        world.solids.push_back(solid);
    }
    return world;
}

Drive drive(Navigator& navigator, const RobotModel& robot, const Course& course, const Pose2& start,
            const Vector2d& waypoint_m, double seconds, double period_s) {
    const sim::World world = course.world();
    sim::Vehicle vehicle(robot, start);
    Drive drive;
    const double step_s = 0.02;
    const int every = static_cast<int>(std::lround(period_s / step_s));
    double omega_radps = 0.0;
    for (int i = 0; i * step_s < seconds && !drive.reached; ++i) {
        const double time_s = i * step_s;
        vehicle.advance(time_s);
        drive.clearance_m =
            std::min(drive.clearance_m, sim::clearance(world, robot, vehicle.pose(), time_s).distance_m);
        drive.v_max_mps = std::max(drive.v_max_mps, vehicle.motion().v_mps);
        drive.time_s = time_s;
        drive.reached = (waypoint_m - Vector2d(vehicle.pose().x_m, vehicle.pose().y_m)).norm() < 0.3;
        if (i % every != 0) continue;
        const COccupancyGridMap2D map = course.local_map(vehicle.pose());
        const Decision decision =
            navigator.decide({time_s, vehicle.pose(), vehicle.motion(), &map, true}, waypoint_m);
        vehicle.command(time_s, decision.command);
        if (decision.command.omega_radps * omega_radps < 0.0) ++drive.turns;
        if (decision.command.omega_radps != 0.0) omega_radps = decision.command.omega_radps;
        drive.decisions.push_back(decision);
    }
    drive.end = vehicle.pose();
    drive.end_motion = vehicle.motion();
    return drive;
}

}  // namespace flownav::nav
