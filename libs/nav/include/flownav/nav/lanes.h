#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "flownav/core/robot_model.h"
#include "flownav/nav/collision_free_distance.h"
#include "flownav/nav/lane_tables.h"

namespace flownav::nav {

/// What a lane is worth, and how fast it may be driven.
struct LaneParams {
    CellLimits limits;
    // Worth of a lane, each between 0 and 1 before weighting.
    double weight_near = 1.0;    ///< how near it leads to the way point
    double weight_free = 0.8;    ///< how far it is free
    double weight_gap = 0.6;     ///< how far obstacles stand from its sides
    double weight_same = 0.1;    ///< how little the turn differs from the present one
    double weight_seen = 0.3;    ///< how much of its ground has been seen
    double weight_sure = 0.5;    ///< how little of it may be an obstacle
    double weight_turn = 0.5;    ///< how little must be turned on the spot
    double away_m = 0.3;         ///< way that is as bad as facing away from the way point at the end
    double horizon_m = 1.5;      ///< gaps and ground farther away do not count
    double free_enough_m = 3.0;  ///< more free way is not better

    double standoff_m = 0.08;      ///< the robot stands this far before what it may not touch
    double bumper_m = 0.4;         ///< unknown ground within this way does not limit the speed
    double unseen_area_m2 = 0.02;  ///< smaller patches of unknown ground do not limit it either
    double unseen_mps = 0.15;      ///< speed over ground that has not been seen
    double narrow_share = 0.35;    ///< of the fastest speed, where obstacles stand right at the sides
    double arrival_mps = 0.15;     ///< least speed toward the way point
    double behind_rad = 1.9;       ///< a way point beyond this bearing is turned to first
    double turned_rad = 0.5;       ///< ... until it is within this one
    double period_s = 0.2;         ///< time until the next decision
    double stop_margin_m = 0.03;   ///< kept to the middle of an occupied cell during an emergency stop
};

/// One lane as the map shows it.
struct LaneView {
    double curvature_1pm = 0.0;
    double heading_rad = 0.0;  ///< turned on the spot before, 0 for arcs
    double free_m = 0.0;       ///< to the first obstacle
    double unseen_m = 0.0;     ///< to the first unseen ground
    double gap_m = 0.0;        ///< to the nearest obstacle at the sides, at most the layout's side_m
    double seen = 1.0;         ///< share of the ground within the horizon
    double sure = 1.0;         ///< 1: nothing on it may be an obstacle
    double near = 0.0;         ///< gain toward the way point within the horizon: 1 all of it, < 0 leads away
    double score = 0.0;
    bool open = false;  ///< there is some way to go
};

struct LaneDecision {
    MotionCommand command;
    CollisionFreeDistance way;                     ///< of the chosen lane
    bool stuck = false;              ///< no lane is open
    int lane = -1;                   ///< chosen of `lanes`
    int heading = -1;                ///< chosen of `headings`: turns on the spot
    std::string why;                 ///< in a few words
    std::vector<LaneView> lanes;     ///< as in the tables, right to left
    std::vector<LaneView> headings;  ///< as in the tables; empty when they were not needed
};

/// Chooses a lane and its speed. The map is in the robot's frame and fits the tables (std::invalid_argument
/// otherwise); its cells speak of the probability of being FREE, 0.5 is unknown. Pure.
LaneDecision choose_lane(const LaneTables& tables, const mrpt::maps::COccupancyGridMap2D& local_map,
                         const Eigen::Vector2d& waypoint_robot_m, const MotionCommand& motion,
                         const LaneParams& params);

}  // namespace flownav::nav
