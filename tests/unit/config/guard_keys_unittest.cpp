#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <sstream>

#include "flownav/config/config.h"

namespace flownav::config {
namespace {

/// Reads the member of a Config that a key is to fill.
using Member = std::function<double(const Config&)>;

const std::map<std::string, Member>& members() {
    static const std::map<std::string, Member> table = {
        {"guard.field_stale_s", [](const Config& c) { return c.guard.sensor.stale_s; }},
        {"guard.future_max_s", [](const Config& c) { return c.guard.sensor.ahead_s; }},
        {"guard.blind_max_s", [](const Config& c) { return c.guard.sensor.blind_s; }},
        {"guard.lost_max_s", [](const Config& c) { return c.guard.sensor.lost_s; }},
        {"guard.starting_s", [](const Config& c) { return c.guard.sensor.waiting_s; }},
        {"guard.sector_blind_max_s", [](const Config& c) { return c.guard.sensor.sector_s; }},
        {"guard.vectors_min", [](const Config& c) { return c.guard.sensor.confident_min; }},
        {"guard.sector_share_min", [](const Config& c) { return c.guard.sensor.sector_share; }},
        {"guard.unconfirmed_within_m", [](const Config& c) { return c.guard.ground.unconfirmed_within_m; }},
        {"guard.unconfirmed_chance", [](const Config& c) { return c.guard.ground.unconfirmed_chance; }},
        {"guard.unconfirmed_memory_s", [](const Config& c) { return c.guard.ground.unconfirmed_s; }},
        {"guard.unconfirmed_mps", [](const Config& c) { return c.guard.collision_checker.unconfirmed_mps; }},
        {"guard.map_stale_s", [](const Config& c) { return c.guard.map_stale_s; }},
        {"guard.compare_s", [](const Config& c) { return c.guard.odometry.window_s; }},
        {"guard.way_tolerance_m", [](const Config& c) { return c.guard.odometry.way_m; }},
        {"guard.way_tolerance_share", [](const Config& c) { return c.guard.odometry.way_share; }},
        {"guard.turn_tolerance_rad", [](const Config& c) { return c.guard.odometry.turn_rad; }},
        {"guard.turn_tolerance_share", [](const Config& c) { return c.guard.odometry.turn_share; }},
        {"guard.jump_m", [](const Config& c) { return c.guard.odometry.jump_m; }},
        {"guard.jump_rad", [](const Config& c) { return c.guard.odometry.jump_rad; }},
        {"guard.jump_hold_s", [](const Config& c) { return c.guard.odometry.hold_s; }},
        {"guard.odometry_stale_s", [](const Config& c) { return c.guard.odometry.silent_s; }},
        {"guard.frozen_fields", [](const Config& c) { return c.guard.odometry.frozen_fields; }},
        {"guard.obstacle_memory_s", [](const Config& c) { return c.guard.ground.obstacle_s; }},
        {"guard.in_view_memory_s", [](const Config& c) { return c.guard.ground.in_view_s; }},
        {"guard.view_half_rad", [](const Config& c) { return c.guard.ground.view_half_rad; }},
        {"guard.free_memory_s", [](const Config& c) { return c.guard.ground.free_s; }},
        {"guard.driven_memory_s", [](const Config& c) { return c.guard.ground.driven_s; }},
        {"guard.seen_near_m", [](const Config& c) { return c.guard.ground.seen_near_m; }},
        {"guard.reach_m", [](const Config& c) { return c.guard.ground.reach_m; }},
        {"guard.margin_m", [](const Config& c) { return c.guard.collision_checker.touch_m; }},
        {"guard.margin_s", [](const Config& c) { return c.guard.collision_checker.margin_s; }},
        {"guard.crawl_mps", [](const Config& c) { return c.guard.collision_checker.crawl_mps; }},
        {"guard.crawl_max_m", [](const Config& c) { return c.guard.crawl_max_m; }},
        {"guard.unseen_max_m", [](const Config& c) { return c.guard.collision_checker.unseen_max_m; }},
        {"guard.command_hold_s", [](const Config& c) { return c.guard.collision_checker.period_s; }},
        {"guard.navigator_silent_s", [](const Config& c) { return c.guard.silent_s; }},
        {"guard.resume_s", [](const Config& c) { return c.guard.resume_s; }},
        {"guard.turn_free_s", [](const Config& c) { return c.guard.turn_free_s; }},
        {"guard.probe_wait_s", [](const Config& c) { return c.guard.probe_wait_s; }},
        {"guard.probe_max_s", [](const Config& c) { return c.guard.probe_max_s; }},
        {"guard.watchdog_s", [](const Config& c) { return c.guard.watchdog_s; }},
        {"navigation.stuck_s", [](const Config& c) { return c.recovery.stuck_s; }},
        {"navigation.held_s", [](const Config& c) { return c.recovery.held_s; }},
        {"navigation.no_progress_s", [](const Config& c) { return c.recovery.no_progress_s; }},
        {"navigation.back_off_m", [](const Config& c) { return c.recovery.back_off_m; }},
        {"navigation.creep_on_m", [](const Config& c) { return c.recovery.creep_on_m; }},
        {"navigation.creep_mps", [](const Config& c) { return c.recovery.creep_mps; }},
        {"navigation.recovery_turn_radps", [](const Config& c) { return c.recovery.turn_radps; }},
        {"navigation.recoveries_max", [](const Config& c) { return c.recovery.recoveries_max; }},
    };
    return table;
}

/// A value that differs from the default and lies within the range.
double other_value(double value) {
    return value == static_cast<int>(value) ? value + 1.0 : value * 1.25;
}

std::string text_of(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

TEST(GuardKeys, EachKeyFillsItsMemberAndNoOther) {
    for (const auto& [key, member] : members()) {
        const double wanted = other_value(member(Config{}));
        Config config;
        set_config_value(config, key, text_of(wanted));
        for (const auto& [other, place] : members())
            EXPECT_NEAR(place(config), other == key ? wanted : place(Config{}), 1e-6) << key << ", " << other;
    }
}

TEST(GuardKeys, EveryKeyOfTheSectionIsChecked) {
    std::size_t of_guard = 0;
    for (const ConfigKey& key : config_keys()) {
        if (key.section != "guard") continue;
        ++of_guard;
        EXPECT_EQ(members().count(key.full_name()), 1U) << key.full_name();
        EXPECT_FALSE(key.everyday) << key.full_name();
    }
    EXPECT_GE(of_guard, 12U);
}

TEST(GuardKeys, TheDefaultsAreThoseOfTheGuard) {
    Config config;
    for (const ConfigKey& key : config_keys()) set_config_value(config, key.full_name(), key.default_value);
    for (const auto& [key, member] : members()) EXPECT_EQ(member(config), member(Config{})) << key;
}

TEST(GuardKeys, OneKeyLimitsTheLeadOfAllTimeStamps) {
    Config config;
    set_config_value(config, "guard.future_max_s", "0.5");
    EXPECT_EQ(config.guard.sensor.ahead_s, 0.5);
    EXPECT_EQ(config.guard.odometry.ahead_s, 0.5);
    EXPECT_EQ(Config{}.guard.sensor.ahead_s, Config{}.guard.odometry.ahead_s);
}

TEST(GuardKeys, AFirstPauseLongerThanTheLongestIsRefused) {
    Config config;
    set_config_value(config, "guard.probe_wait_s", "9");
    try {
        check_navigation(config);
        FAIL() << "was taken";
    } catch (const ConfigError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "guard.probe_wait_s = 9: is more than guard.probe_max_s; allowed: up to 8");
    }
}

}  // namespace
}  // namespace flownav::config
