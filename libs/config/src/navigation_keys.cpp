#include <algorithm>

#include "config_key.h"
#include "flownav/nav/make_navigator.h"
#include "registered_name.h"

namespace flownav::config {
namespace {

Polygon parse_footprint(const std::string& text) {
    const auto words = words_of(text);
    if (words.size() < 6 || words.size() % 2 != 0)
        throw BadValue("does not have x and y of 3 or more corners");
    Polygon corners;
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const Range<double> range{-10, 10};
        corners.emplace_back(parse_number(words[i], range), parse_number(words[i + 1], range));
    }
    if (signed_distance_m(corners, Eigen::Vector2d::Zero()) >= 0.0)
        throw BadValue("does not hold the axis the robot turns about, 0 0, inside");
    if (signed_area_m2(corners) < 0.0) std::reverse(corners.begin(), corners.end());
    return corners;
}

std::string format_footprint(const Polygon& corners) {
    std::string text;
    for (const Eigen::Vector2d& corner : corners) {
        text += (text.empty() ? "" : "  ") + format_number(corner.x()) + ' ' + format_number(corner.y());
    }
    return text;
}

Key footprint() {
    return make_key(
        {"navigation", "footprint_m", "m", "corners of the robot seen from above, x y each, x forward",
         everyday},
        "x y of 3 or more corners, each -10 .. 10, around 0 0",
        [](const Config& config) { return format_footprint(config.navigation.robot.footprint_m); },
        [](Config& config, const std::string& text) {
            config.navigation.robot.footprint_m = parse_footprint(text);
        });
}

std::vector<Key> robot_keys() {
    return {
        footprint(),
        number<double>({"navigation", "robot_height_m", "m",
                        "height of the robot; obstacles that hang higher cannot be hit", everyday},
                       {0.05, 10}, AT(navigation.robot.height_m)),
        number<double>({"navigation", "v_max_mps", "m/s", "fastest speed forward", everyday}, {0.05, 10},
                       AT(navigation.robot.v_max_mps)),
        number<double>({"navigation", "v_back_mps", "m/s", "fastest speed backward", everyday}, {0.01, 10},
                       AT(navigation.robot.v_back_mps)),
        number<double>({"navigation", "omega_max_radps", "rad/s", "fastest turn", everyday}, {0.05, 10},
                       AT(navigation.robot.omega_max_radps)),
        number<double>({"navigation", "accel_mps2", "m/s^2", "when speeding up", everyday}, {0.05, 20},
                       AT(navigation.robot.accel_mps2)),
        number<double>({"navigation", "brake_mps2", "m/s^2", "when slowing down", everyday}, {0.05, 20},
                       AT(navigation.robot.brake_mps2)),
        number<double>({"navigation", "alpha_radps2", "rad/s^2", "change of the turn, either way"},
                       {0.05, 50}, AT(navigation.robot.alpha_radps2)),
        number<double>({"navigation", "delay_s", "s", "from a command to its effect", everyday}, {0, 2},
                       AT(navigation.robot.delay_s)),
    };
}

std::vector<Key> recovery_keys() {
    return {
        number<double>(
            {"navigation", "stuck_s", "s", "a recovery begins when the navigator sees no way for so long"},
            {0.1, 60}, AT(recovery.stuck_s)),
        number<double>({"navigation", "held_s", "s",
                        "a recovery begins when a robot that wants to move stands for so long"},
                       {0.1, 60}, AT(recovery.held_s)),
        number<double>({"navigation", "no_progress_s", "s",
                        "a recovery begins when the robot comes no nearer for so long"},
                       {0.5, 600}, AT(recovery.no_progress_s)),
        number<double>({"navigation", "back_off_m", "m", "length of backing off"}, {0.05, 5},
                       AT(recovery.back_off_m)),
        number<double>({"navigation", "creep_on_m", "m", "length of creeping straight on"}, {0.05, 5},
                       AT(recovery.creep_on_m)),
        number<double>({"navigation", "creep_mps", "m/s", "speed of creeping; below guard.crawl_mps"},
                       {0.01, 1}, AT(recovery.creep_mps)),
        number<double>({"navigation", "recovery_turn_radps", "rad/s", "turn rate of recoveries"}, {0.05, 10},
                       AT(recovery.turn_radps)),
        number<int>(
            {"navigation", "recoveries_max", "", "recoveries without progress before the robot is blocked"},
            {1, 1000}, AT(recovery.recoveries_max)),
    };
}

}  // namespace

std::vector<Key> navigation_keys() {
    std::vector<Key> keys = {
        registered_name({"navigation", "navigator", "",
                         "circular lanes over the local map, or MRPT's reactive navigation", everyday},
                        nav::navigator_names, AT(navigation.navigator)),
        word<nav::ReplanPolicy>(
            {"navigation", "replan", "", "when ways are planned on the map of the whole drive", everyday},
            {{"always", nav::ReplanPolicy::Always},
             {"when_stuck", nav::ReplanPolicy::WhenStuck},
             {"never", nav::ReplanPolicy::Never}},
            AT(recovery.replan)),
        number<double>({"navigation", "goal_radius_m", "m", "arrived when this near", everyday}, {0.05, 10},
                       AT(recovery.goal_radius_m)),
        number<double>({"navigation", "controller_period_s", "s", "period of the navigator"}, {0.02, 1},
                       AT(navigation.controller_period_s)),
    };
    for (const auto& more : {robot_keys(), recovery_keys()})
        keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

}  // namespace flownav::config
