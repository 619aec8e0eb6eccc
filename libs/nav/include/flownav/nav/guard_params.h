#pragma once

#include <cstddef>

#include "flownav/mapping/occupancy_limits.h"

// The numbers of the guard, one struct a part. The ini's section [guard] fills them.
namespace flownav::nav {

struct SensorWatchParams {
    double stale_s = 0.25;       ///< largest age of the newest field, by its time stamp and by its arrival
    double ahead_s = 0.1;        ///< largest lead of a time stamp over the clock
    double blind_s = 0.2;        ///< longest time without a field that has enough vectors
    double lost_s = 0.2;         ///< longest time without omega
    double waiting_s = 0.4;      ///< added to blind_s and lost_s while the sensor starts anew
    double sector_s = 0.1;       ///< longest time a sector of the image may be blind
    int confident_min = 20;      ///< confident vectors of a field; with fewer the field is blind
    double sector_share = 0.05;  ///< share of confident blocks of a sector; below it the sector is blind
};

struct OdometryWatchParams {
    double window_s = 1.5;       ///< time over which flow and wheels are compared
    double way_m = 0.1;          ///< tolerated difference of the way: this and way_share of the way
    double way_share = 0.25;     ///< see way_m
    double turn_rad = 0.12;      ///< tolerated difference of the turn: this and turn_share of the turn
    double turn_share = 0.2;     ///< see turn_rad
    double jump_m = 0.05;        ///< a step of the wheels' pose this much longer than possible is a jump
    double jump_rad = 0.1;       ///< a turn of the wheels' pose this much larger than possible is a jump
    double silent_s = 0.5;       ///< longest time without odometry, once there was some
    double hold_s = 1.0;         ///< the robot stands for so long after a jump
    double ahead_s = 0.1;        ///< largest lead of a time stamp over the clock
    int frozen_fields = 3;       ///< so many identical images in a row are a frozen sensor,
    double frozen_way_m = 0.01;  ///< when the outline moves this far by the wheels meanwhile
};

struct GroundMemoryParams {
    double cell_m = 0.05;             ///< edge of a cell
    double reach_m = 4.0;             ///< half the edge of the remembered square around the robot
    mapping::OccupancyLimits limits;  ///< of the local maps
    double obstacle_s = 60.0;         ///< time until an obstacle that the map no longer shows is forgotten
    double in_view_s = 10.0;          ///< the same for an obstacle in view of the camera
    double view_half_rad = 0.35;      ///< half the angle of view that in_view_s applies to
    double free_s = 30.0;             ///< time until free ground is forgotten
    double driven_s = 120.0;          ///< time until ground that the robot drove over is forgotten
    double seen_near_m = 0.08;        ///< unknown ground this near to free ground counts as seen
    // Unknown ground in view of a contact scan.
    double unconfirmed_within_m = 1.2;  ///< forward distance up to which it may become unconfirmed; 0: off
    double unconfirmed_chance = 0.02;   ///< unconfirmed when scans miss floor so often with a smaller chance
    double unconfirmed_s = 60.0;        ///< time until it is forgotten
};

struct CollisionCheckerParams {
    double period_s = 0.06;        ///< shortest time that a command is assumed to be in force
    double touch_m = 0.02;         ///< distance kept to obstacles at any speed
    double margin_s = 0.1;         ///< distance added per m/s of the outline beyond crawl_mps
    double crawl_mps = 0.1;        ///< speed of the fastest point of the outline of a robot that crawls
    double unseen_max_m = 0.1;     ///< length of the outline that may pass over unseen ground
    double unconfirmed_mps = 0.3;  ///< fastest speed while the floor on the way is not confirmed
};

struct GuardParams {
    SensorWatchParams sensor;
    OdometryWatchParams odometry;
    GroundMemoryParams ground;
    CollisionCheckerParams collision_checker;
    bool needs_fields = true;    ///< false: another sensor sees the obstacles, only the map is watched
    double pose_jump_m = 0.25;   ///< a step of the pose in the map this much longer than possible is a jump
    double pose_jump_rad = 0.2;  ///< a turn of the pose in the map this much larger than possible is a jump
    double map_stale_s = 1.5;    ///< largest age of the newest local map
    double silent_s = 0.3;       ///< longest time without a proposal; longer than the navigator's period
    double resume_s = 0.4;       ///< time without a fault before the robot moves again
    double crawl_max_m = 0.6;    ///< longest way over unseen ground while no new ground is seen
    int new_cells = 8;           ///< free cells of one map that are new ground
    double turn_free_s = 3.0;    ///< a robot with a blind sector may turn in place after standing so long
    double probe_wait_s = 1.0;   ///< first pause after flow and wheels disagreed; doubles each time
    double probe_max_s = 8.0;    ///< longest pause; at least probe_wait_s
    double log_quiet_s = 0.3;    ///< a milder decision is logged when it has lasted so long
    double watchdog_s = 1.0;     ///< the watchdog stops a real base when the loop hangs for so long
    std::size_t events_max = 10000;
};

}  // namespace flownav::nav
