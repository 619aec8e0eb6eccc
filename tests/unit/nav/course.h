#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <vector>

#include "flownav/core/robot_model.h"
#include "flownav/nav/navigator.h"
#include "flownav/sim/world.h"

namespace flownav::nav {

/// Posts on a floor, and the local map of an ideal sensor.
struct Course {
    struct Post {
        Eigen::Vector2d at_m;
        double radius_m = 0.075;
    };

    std::vector<Post> posts;
    double cell_m = 0.05;
    double size_m = 10.0;
    float p_elsewhere = 0.9F;  ///< value of the cells between the posts

    void add(double x_m, double y_m, double radius_m = 0.075) { posts.push_back({{x_m, y_m}, radius_m}); }
    /// Adds posts side by side from a to b.
    void add_wall(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);

    mrpt::maps::COccupancyGridMap2D local_map(const Pose2& T_map_robot) const;
    sim::World world() const;
};

/// Result of a drive.
struct Drive {
    Pose2 end;
    MotionCommand end_motion;
    double time_s = 0.0;
    double clearance_m = 1e9;  ///< smallest distance of the footprint to a post
    double v_max_mps = 0.0;
    bool reached = false;  ///< came within 0.3 m of the way point
    int turns = 0;         ///< number of sign changes of the commanded omega
    std::vector<Decision> decisions;
};

/// Drives the simulated vehicle in a closed loop, with a decision every `period_s`, until the way point is
/// reached.
Drive drive(Navigator& navigator, const RobotModel& robot, const Course& course, const Pose2& start,
            const Eigen::Vector2d& waypoint_m, double seconds, double period_s = 0.2);

}  // namespace flownav::nav
