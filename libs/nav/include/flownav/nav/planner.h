#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <vector>

#include "flownav/core/robot_model.h"
#include "flownav/mapping/occupancy_limits.h"

namespace flownav::nav {

struct PlanParams {
    double margin_m = 0.07;           ///< distance kept beyond the robot's half width on any path
    double comfort_m = 0.3;           ///< ways nearer than this to an obstacle, beyond the margin, cost more
    double comfort_cost = 6.0;        ///< of a metre right at the margin, in metres
    double unknown_cost = 1.5;        ///< of a metre through unseen ground, in metres
    mapping::OccupancyLimits limits;  ///< of the map
    std::vector<Eigen::Vector2d> avoid_m;  ///< places of the map where the robot got stuck,
    double avoid_radius_m = 0.4;           ///< nearer to one than this
    double avoid_cost = 8.0;               ///< a metre costs so much more, in metres; again for each
    double bold_margin_m = 0.03;           ///< margin of the last attempt to find a path
    double doubt_cost_m = 4.0;   ///< a detour may cost so much more than a way past doubtful obstacles
    double area_margin_m = 6.0;  ///< how far beside start, goal and map a way may lead
    double area_max_m = 200.0;   ///< edge of the planned area
    double look_near_m = 0.5;    ///< the way point is at least this far along the path
    double look_ahead_m = 1.6;   ///< of the way point that a local navigator is given
};

/// Path over the map, from the robot to the goal.
struct Plan {
    std::vector<Eigen::Vector2d> path_m;  ///< map frame, begins at the robot; never empty
    double cost_m = 0.0;                  ///< length, and what its places cost beside it
    /// What a local navigator is to drive to: the farthest point of the path within params.look_ahead_m that
    /// a straight line reaches over ground no dearer than the path's.
    Eigen::Vector2d way_point_m = Eigen::Vector2d::Zero();
    bool reaches_goal = false;  ///< false: the path ends as near to the goal as one can get
};

/// Cheapest path (A* over the cells of the map, eight neighbours) for the middle of the robot. Cells of
/// the map hold the probability of being FREE; 0.5 is unknown, as are all cells outside the map.
/// A robot that stands too near to an obstacle is led away from it first.
Plan plan(const mrpt::maps::COccupancyGridMap2D& map, const Eigen::Vector2d& from_m,
          const Eigen::Vector2d& goal_m, const RobotModel& robot, const PlanParams& params);

/// Length of a path.
double length_m(const std::vector<Eigen::Vector2d>& path_m);

/// Half the width of the widest circle about the origin inside the footprint.
double inscribed_radius_m(const Polygon& footprint);

}  // namespace flownav::nav
