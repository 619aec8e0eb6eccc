#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "flownav/core/robot_model.h"
#include "flownav/nav/collision_free_distance.h"
#include "flownav/nav/lane_tables.h"

namespace flownav::nav {

/// Weights and speed limits of lanes.
struct LaneParams {
    mapping::OccupancyLimits limits;
    // Weights of the score; each term is between 0 and 1 before weighting.
    double weight_near = 1.0;    ///< how near it leads to the way point
    double weight_free = 0.8;    ///< how far it is free
    double weight_gap = 0.6;     ///< how far obstacles stand from its sides
    double weight_same = 0.1;    ///< how little the turn differs from the present one
    double weight_seen = 0.3;    ///< share of its ground that has been seen
    double weight_sure = 0.5;    ///< how few of its cells may be obstacles
    double weight_turn = 0.5;    ///< how little must be turned on the spot
    double away_m = 0.3;         ///< distance equivalent to facing away from the way point at the end
    double horizon_m = 1.5;      ///< gaps and ground farther away do not count
    double free_enough_m = 3.0;  ///< free distance beyond this adds no score

    double standoff_m = 0.08;      ///< distance kept to an obstacle at the end of a lane
    double bumper_m = 0.4;         ///< unknown ground within this distance does not limit the speed
    double unseen_area_m2 = 0.02;  ///< smaller patches of unknown ground do not limit the speed
    double unseen_mps = 0.3;       ///< speed over ground that has not been seen
    double narrow_share = 0.35;    ///< share of the maximum speed where obstacles stand right at the sides
    double arrival_mps = 0.15;     ///< minimum speed toward the way point
    double behind_rad = 1.9;       ///< the robot first turns to a way point beyond this bearing
    double turned_rad = 0.5;       ///< it stops turning within this bearing
    double period_s = 0.2;         ///< time until the next decision
    double stop_margin_m = 0.03;   ///< kept to the middle of an occupied cell during an emergency stop
};

/// Evaluation of one lane on the map.
struct LaneView {
    double curvature_1pm = 0.0;
    double heading_rad = 0.0;  ///< turn on the spot before the lane, 0 for arcs
    double free_m = 0.0;       ///< distance to the first obstacle
    double unseen_m = 0.0;     ///< distance to the first unseen ground
    double gap_m = 0.0;        ///< to the nearest obstacle at the sides, at most the layout's side_m
    double seen = 1.0;         ///< share of the ground within the horizon that has been seen
    double sure = 1.0;         ///< 1: no cell of it may be an obstacle
    double near = 0.0;         ///< gain toward the way point within the horizon: 1 all of it, < 0 leads away
    double score = 0.0;
    bool open = false;  ///< the free distance suffices to drive along it
};

struct LaneDecision {
    MotionCommand command;
    CollisionFreeDistance way;    ///< of the chosen lane
    bool stuck = false;           ///< no lane is open
    int lane = -1;                ///< index of the chosen lane in `lanes`; -1: none
    int heading = -1;             ///< index of the chosen heading in `headings`, a turn on the spot; -1: none
    std::string why;              ///< reason in a few words
    std::vector<LaneView> lanes;  ///< as in the tables, right to left
    std::vector<LaneView> headings;  ///< as in the tables; empty when they were not evaluated
};

/// Chooses a lane and its speed. The map is in the robot's frame; its cells hold the probability of being
/// FREE, 0.5 is unknown. Pure. Throws std::invalid_argument when the map does not fit the tables.
LaneDecision choose_lane(const LaneTables& tables, const mrpt::maps::COccupancyGridMap2D& local_map,
                         const Eigen::Vector2d& waypoint_robot_m, const MotionCommand& motion,
                         const LaneParams& params);

}  // namespace flownav::nav
