#include "config_key.h"

namespace flownav::config {
namespace {

/// A number of the section [guard].
template <class T, class... Places>
Key guard(const char* name, const char* unit, const char* help, Range<T> range, Places... places) {
    return number<T>({"guard", name, unit, help}, range, places...);
}

std::vector<Key> sensor_keys() {
    return {
        guard<double>("field_stale_s", "s", "stops when the newest field is older", {0.02, 10},
                      AT(guard.sensor.stale_s)),
        guard<double>("future_max_s", "s", "time stamps farther in the future are ignored", {0, 10},
                      AT(guard.sensor.ahead_s), AT(guard.odometry.ahead_s)),
        guard<double>("blind_max_s", "s", "stops after so long without a field that has enough vectors",
                      {0, 10}, AT(guard.sensor.blind_s)),
        guard<double>("lost_max_s", "s", "stops after so long without a common motion of the vectors",
                      {0, 10}, AT(guard.sensor.lost_s)),
        guard<double>("starting_s", "s", "added to blind_max_s and lost_max_s while the sensor starts anew",
                      {0, 10}, AT(guard.sensor.waiting_s)),
        guard<double>("sector_blind_max_s", "s", "stops after a quarter of the image was blind for so long",
                      {0, 10}, AT(guard.sensor.sector_s)),
        guard<int>("vectors_min", "", "a field with fewer confident vectors is blind", {1, 1000},
                   AT(guard.sensor.confident_min)),
        guard<double>("sector_share_min", "", "a quarter with a smaller share of confident blocks is blind",
                      {0, 1}, AT(guard.sensor.sector_share)),
        guard<double>("map_stale_s", "s", "stops when the newest local map is older", {0.1, 60},
                      AT(guard.map_stale_s)),
    };
}

std::vector<Key> odometry_keys() {
    return {
        guard<double>("compare_s", "s", "time over which flow and wheels are compared", {0.2, 30},
                      AT(guard.odometry.window_s)),
        guard<double>("way_tolerance_m", "m", "stops when the ways of flow and wheels differ by more, ...",
                      {0, 10}, AT(guard.odometry.way_m)),
        guard<double>("way_tolerance_share", "", "... and by more than this share of the way in addition",
                      {0, 10}, AT(guard.odometry.way_share)),
        guard<double>("turn_tolerance_rad", "rad",
                      "stops when the turns of flow and wheels differ by more, ...", {0, 6},
                      AT(guard.odometry.turn_rad)),
        guard<double>("turn_tolerance_share", "", "... and by more than this share of the turn in addition",
                      {0, 10}, AT(guard.odometry.turn_share)),
        guard<double>("jump_m", "m", "the wheels jump when they go so much farther than the robot can",
                      {0, 10}, AT(guard.odometry.jump_m)),
        guard<double>("jump_rad", "rad", "the wheels jump when they turn so much more than the robot can",
                      {0, 6}, AT(guard.odometry.jump_rad)),
        guard<double>("jump_hold_s", "s", "stands for so long after a jump", {0, 60},
                      AT(guard.odometry.hold_s)),
        guard<double>("odometry_stale_s", "s", "stops after so long without odometry, once there was some",
                      {0.05, 10}, AT(guard.odometry.silent_s)),
        guard<int>("frozen_fields", "", "stops after so many identical images in a row while moving",
                   {1, 1000}, AT(guard.odometry.frozen_fields)),
    };
}

std::vector<Key> ground_keys() {
    return {
        guard<double>("obstacle_memory_s", "s", "an obstacle that the map no longer shows stays for so long",
                      {0, 3600}, AT(guard.ground.obstacle_s)),
        guard<double>("in_view_memory_s", "s", "the same for an obstacle in view of the camera", {0, 3600},
                      AT(guard.ground.in_view_s)),
        guard<double>("view_half_rad", "rad", "half the angle of view that in_view_memory_s applies to",
                      {0, 3.2}, AT(guard.ground.view_half_rad)),
        guard<double>("free_memory_s", "s", "free ground counts as seen for so long", {0, 3600},
                      AT(guard.ground.free_s)),
        guard<double>("driven_memory_s", "s", "ground that was driven over counts as seen for so long",
                      {0, 3600}, AT(guard.ground.driven_s)),
        guard<double>("seen_near_m", "m", "unknown ground this near to free ground counts as seen", {0, 2},
                      AT(guard.ground.seen_near_m)),
        guard<double>("unconfirmed_within_m", "m",
                      "ground in view up to so far ahead may become unconfirmed: not driven on; 0: off",
                      {0, 10}, AT(guard.ground.unconfirmed_within_m)),
        guard<double>("unconfirmed_chance", "",
                      "unconfirmed is ground where scans would miss floor with a smaller chance", {1e-6, 0.5},
                      AT(guard.ground.unconfirmed_chance)),
        guard<double>("unconfirmed_memory_s", "s",
                      "unconfirmed ground that no scan looks at stays so for so long", {0, 3600},
                      AT(guard.ground.unconfirmed_s)),
        guard<double>("reach_m", "m", "ground this far around the robot is remembered", {1, 20},
                      AT(guard.ground.reach_m)),
    };
}

std::vector<Key> margin_keys() {
    return {
        guard<double>("margin_m", "m", "distance kept to obstacles at any speed", {0, 2},
                      AT(guard.collision_checker.touch_m)),
        guard<double>("margin_s", "s", "distance added for each m/s of the outline beyond crawl_mps", {0, 5},
                      AT(guard.collision_checker.margin_s)),
        guard<double>("crawl_mps", "m/s", "fastest speed of the outline over unseen ground", {0.01, 2},
                      AT(guard.collision_checker.crawl_mps)),
        guard<double>("crawl_max_m", "m", "longest way over unseen ground while no new ground is seen",
                      {0, 100}, AT(guard.crawl_max_m)),
        guard<double>("unseen_max_m", "m", "length of the outline that may pass over unseen ground", {0, 5},
                      AT(guard.collision_checker.unseen_max_m)),
        guard<double>("unconfirmed_mps", "m/s",
                      "fastest speed while no contact scan has confirmed the floor on the way", {0.01, 10},
                      AT(guard.collision_checker.unconfirmed_mps)),
        guard<double>("command_hold_s", "s", "shortest time that a command is assumed to be in force",
                      {0.01, 1}, AT(guard.collision_checker.period_s)),
    };
}

std::vector<Key> time_keys() {
    return {
        guard<double>("navigator_silent_s", "s",
                      "stops after so long without a proposal; at least 1.5 navigation.controller_period_s",
                      {0.05, 10}, AT(guard.silent_s)),
        guard<double>("resume_s", "s", "drives on after so long without a fault", {0, 60},
                      AT(guard.resume_s)),
        guard<double>("turn_free_s", "s", "with a blind quarter it may turn in place after standing so long",
                      {0, 600}, AT(guard.turn_free_s)),
        guard<double>("probe_wait_s", "s", "first pause after flow and wheels disagreed; doubles each time",
                      {0, 600}, AT(guard.probe_wait_s)),
        guard<double>("probe_max_s", "s", "longest pause after flow and wheels disagreed", {0, 600},
                      AT(guard.probe_max_s)),
        guard<double>("watchdog_s", "s", "a real robot is stopped when the control loop hangs for so long",
                      {0.1, 60}, AT(guard.watchdog_s)),
    };
}

}  // namespace

std::vector<Key> guard_keys() {
    std::vector<Key> keys;
    for (const auto& more : {sensor_keys(), odometry_keys(), ground_keys(), margin_keys(), time_keys()})
        keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

}  // namespace flownav::config
