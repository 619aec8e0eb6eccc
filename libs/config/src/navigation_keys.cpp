#include <algorithm>

#include "config_key.h"

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
        {"navigation", "footprint_m", "m", "corners of the robot seen from above, x y each, x forward"},
        "x y of 3 or more corners, each -10 .. 10, around 0 0",
        [](const Config& config) { return format_footprint(config.navigation.robot.footprint_m); },
        [](Config& config, const std::string& text) {
            config.navigation.robot.footprint_m = parse_footprint(text);
        });
}

std::vector<Key> robot_keys() {
    return {
        footprint(),
        number<double>({"navigation", "robot_height_m", "m", "what hangs higher cannot be hit"}, {0.05, 10},
                       AT(navigation.robot.height_m)),
        number<double>({"navigation", "v_max_mps", "m/s", "fastest speed forward"}, {0.05, 10},
                       AT(navigation.robot.v_max_mps)),
        number<double>({"navigation", "v_back_mps", "m/s", "fastest speed backward"}, {0.01, 10},
                       AT(navigation.robot.v_back_mps)),
        number<double>({"navigation", "omega_max_radps", "rad/s", "fastest turn"}, {0.05, 10},
                       AT(navigation.robot.omega_max_radps)),
        number<double>({"navigation", "accel_mps2", "m/s^2", "when speeding up"}, {0.05, 20},
                       AT(navigation.robot.accel_mps2)),
        number<double>({"navigation", "brake_mps2", "m/s^2", "when slowing down"}, {0.05, 20},
                       AT(navigation.robot.brake_mps2)),
        number<double>({"navigation", "alpha_radps2", "rad/s^2", "change of the turn, either way"},
                       {0.05, 50}, AT(navigation.robot.alpha_radps2)),
        number<double>({"navigation", "delay_s", "s", "from a command to its effect"}, {0, 2},
                       AT(navigation.robot.delay_s)),
    };
}

}  // namespace

std::vector<Key> navigation_keys() {
    std::vector<Key> keys = {
        word<NavigatorKind>({"navigation", "navigator", "",
                             "circular lanes over the local map, or MRPT's reactive navigation"},
                            {{"lanes", NavigatorKind::Lanes}, {"reactive", NavigatorKind::Reactive}},
                            AT(navigation.navigator)),
        word<PlanPolicy>(
            {"navigation", "plan", "", "when ways are planned on the map of the whole drive"},
            {{"always", PlanPolicy::Always}, {"stuck", PlanPolicy::Stuck}, {"never", PlanPolicy::Never}},
            AT(navigation.plan)),
        number<double>({"navigation", "goal_radius_m", "m", "arrived when this near"}, {0.05, 10},
                       AT(navigation.goal_radius_m)),
        number<double>({"navigation", "decide_every_s", "s", "period of the navigator"}, {0.02, 1},
                       AT(navigation.controller_period_s)),
    };
    for (const Key& key : robot_keys()) keys.push_back(key);
    return keys;
}

}  // namespace flownav::config
