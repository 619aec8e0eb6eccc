#include "flownav/config/config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace flownav::config {
namespace {

std::string error_of(const std::string& key, const std::string& value) {
    Config config;
    try {
        set_config_value(config, key, value);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "";
}

Config with(const std::string& key, const std::string& value) {
    Config config;
    set_config_value(config, key, value);
    return config;
}

TEST(Config, EveryDefaultIsAnAllowedValueAndReadsBackAsItself) {
    for (const ConfigKey& key : config_keys()) {
        const std::string name = key.section + "." + key.name;
        EXPECT_EQ(error_of(name, key.default_value), "");
        EXPECT_EQ(dump_config(with(name, key.default_value)), dump_config(Config{}));
    }
}

TEST(Config, EveryKeyIsDocumentedAndNamedOnce) {
    std::set<std::string> names;
    for (const ConfigKey& key : config_keys()) {
        EXPECT_TRUE(names.insert(key.section + "." + key.name).second) << key.name;
        EXPECT_FALSE(key.help.empty()) << key.name;
        EXPECT_FALSE(key.range.empty()) << key.name;
    }
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(Config, AtMost30KeysAreEverydayKeysAndStandBeforeTheAdvancedOnes) {
    const std::string all = dump_config(Config{});
    const std::string everyday = dump_config(Config{}, KeySet::Everyday);
    EXPECT_EQ(all.rfind(everyday, 0), 0U);
    EXPECT_NE(all.find("# Advanced", everyday.size()), std::string::npos);
    std::size_t keys = 0;
    for (const ConfigKey& key : config_keys()) {
        keys += key.everyday ? 1U : 0U;
        const std::string line = "\n" + key.name + " = " + key.default_value + "\n";
        EXPECT_EQ(count(everyday, line), key.everyday ? 1U : 0U) << key.name;
        EXPECT_EQ(count(all, line), 1U) << key.name;
    }
    EXPECT_LE(keys, 30U);
    EXPECT_EQ(count(document_config(KeySet::Everyday), "\n"), keys + 2);
}

TEST(Config, TheTextOfAKeyIsThatOfTheDump) {
    const Config config = with("obstacles.tau_px", "1.375");
    EXPECT_EQ(config_value(config, "obstacles.tau_px"), "1.375");
    EXPECT_EQ(config_value(config, "camera.height_m"), "recorded");
    EXPECT_THROW(config_value(config, "obstacles.tau"), ConfigError);
}

TEST(Config, LimitsOfCellsLieOnTheirSideOfTheUnknown) {
    EXPECT_EQ(with("map.guard_obstacle_below", "0.2").map.occupancy.guard_obstacle_below, 0.2);
    EXPECT_EQ(with("map.export_free_above", "0.8").map.occupancy.export_free_above, 0.8);
    for (const ConfigKey& key : config_keys()) {
        if (key.name.find("_below") == std::string::npos && key.name.find("_above") == std::string::npos)
            continue;
        EXPECT_NE(error_of(key.section + "." + key.name, "0.5"), "") << key.name;
    }
}

TEST(Config, LimitsOfContactsInTheWrongOrderAreRefusedByName) {
    EXPECT_NO_THROW(check_contacts(with("obstacles.contact_min_m", "3.6")));
    EXPECT_THROW(check_contacts(with("obstacles.contact_min_m", "3.7")), ConfigError);
    try {
        check_contacts(with("obstacles.contact_votes", "31"));
        FAIL() << "accepted";
    } catch (const ConfigError& error) {
        EXPECT_EQ(
            std::string(error.what()),
            "obstacles.contact_votes = 31: is more than obstacles.contact_votes_sure; allowed: up to 30");
    }
}

TEST(Config, LimitsOfCellsInTheWrongOrderAreRefusedByName) {
    EXPECT_NO_THROW(check_map(with("map.obstacle_below", "0.47")));
    EXPECT_THROW(check_map(with("map.obstacle_below", "0.48")), ConfigError);
    EXPECT_NO_THROW(check_map(with("map.plan_certain_below", "0.45")));
    try {
        check_map(with("map.plan_certain_below", "0.46"));
        FAIL() << "accepted";
    } catch (const ConfigError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "map.plan_certain_below = 0.46: is more than map.plan_obstacle_below; allowed: up to 0.45");
    }
}

// Converts a unit to its form in names: m/s^2 becomes mps2.
std::string in_a_name(std::string unit) {
    std::replace(unit.begin(), unit.end(), '/', 'p');
    unit.erase(std::remove(unit.begin(), unit.end(), '^'), unit.end());
    return unit;
}

TEST(Config, UnitsInNamesAreTheDocumentedUnits) {
    for (const ConfigKey& key : config_keys()) {
        const bool named = key.unit.empty() || key.name.find("_" + in_a_name(key.unit)) != std::string::npos;
        EXPECT_TRUE(named) << key.name << " in " << key.unit;
    }
}

TEST(Config, ValuesReachTheirPlaces) {
    EXPECT_EQ(with("camera.camera_label", "CAMERA2").camera.camera_label, "CAMERA2");
    EXPECT_EQ(with("camera.interlaced", "top_first").camera.interlaced, Interlaced::TopFirst);
    EXPECT_EQ(with("camera.height_m", "1.65").camera.height_m, 1.65);
    EXPECT_EQ(with("camera.pitch_deg", "14").camera.pitch_deg, 14.0);
    EXPECT_EQ(with("camera.roll_deg", "-1.4").camera.roll_deg, -1.4);
    EXPECT_EQ(with("camera.forward_m", "1.1").camera.forward_m, 1.1);
    EXPECT_EQ(with("camera.left_m", "-0.2").camera.left_m, -0.2);
    EXPECT_EQ(with("camera.fx_px", "718.8").camera.fx_px, 718.8);
    EXPECT_EQ(with("camera.fy_px", "359.4").camera.fy_px, 359.4);
    EXPECT_EQ(with("camera.cx_px", "607.1").camera.cx_px, 607.1);
    EXPECT_EQ(with("camera.cy_px", "185.2").camera.cy_px, 185.2);
    EXPECT_EQ(with("flow.blocks", "2000").pipeline.flow.blocks, 2000);
    EXPECT_EQ(with("flow.subpixel", "parabola").pipeline.flow.subpixel, flow::Subpixel::Parabola);
    EXPECT_EQ(with("flow.confidence_min", "0.12").pipeline.flow.confidence_min, 0.12);
    EXPECT_EQ(with("flow.focus_exclusion", "0.08").pipeline.flow.focus_exclusion, 0.08);
    EXPECT_EQ(with("motion.geometry", "block").pipeline.motion.geometry, Geometry::Block);
    EXPECT_EQ(with("motion.motion_model", "yaw").pipeline.motion.model, motion::MotionModel::Yaw);
    EXPECT_EQ(with("motion.travel_m", "0.1").pipeline.rate.travel_m, 0.1);
    EXPECT_EQ(with("motion.gap_max_s", "1").pipeline.rate.gap_max_s, 1.0);
    EXPECT_EQ(with("motion.carry_max_s", "0.5").pipeline.rate.carry_max_s, 0.5);
    EXPECT_EQ(with("obstacles.tau_px", "2").pipeline.obstacles.tau_px, 2.0);
    EXPECT_EQ(with("obstacles.neighbours", "3").pipeline.obstacles.neighbours, 3);
    EXPECT_EQ(with("obstacles.range_max_m", "25").pipeline.obstacles.range_max_m, 25.0);
    EXPECT_EQ(with("obstacles.height_max_m", "3").pipeline.obstacles.height_max_m, 3.0);
    EXPECT_EQ(with("obstacles.beam_deg", "1").pipeline.obstacles.beam_deg, 1.0);
    EXPECT_EQ(with("map.resolution_m", "0.2").map.resolution_m, 0.2);
    EXPECT_EQ(with("map.size_m", "40").map.size_m, 40.0);
    EXPECT_EQ(with("map.memory_s", "2").map.memory_s, 2.0);
    EXPECT_EQ(with("navigation.navigator", "reactive").navigation.navigator, "reactive");
    EXPECT_EQ(with("navigation.replan", "never").recovery.replan, nav::ReplanPolicy::Never);
    EXPECT_EQ(with("navigation.v_max_mps", "1.2").navigation.robot.v_max_mps, 1.2);
    EXPECT_EQ(with("navigation.brake_mps2", "2.5").navigation.robot.brake_mps2, 2.5);
}

TEST(Config, TheFootprintIsKeptCounterClockwiseAroundTheAxis) {
    const Polygon clockwise =
        with("navigation.footprint_m", "1 0.5, 1 -0.5, -1 0").navigation.robot.footprint_m;
    ASSERT_EQ(clockwise.size(), 3U);
    EXPECT_GT(signed_area_m2(clockwise), 0.0);
    EXPECT_EQ(clockwise.back(), Eigen::Vector2d(1.0, 0.5));
    EXPECT_NE(error_of("navigation.footprint_m", "1 0 2 0"), "");
    EXPECT_NE(error_of("navigation.footprint_m", "1 0 2 0 2 1 1"), "");
    EXPECT_NE(error_of("navigation.footprint_m", "1 0 2 0 2 1"), "");  // the axis lies outside
}

TEST(Config, LambdaIsOneKeyForMotionAndObstacles) {
    const Config config = with("obstacles.lambda_px", "2.5");
    EXPECT_EQ(config.pipeline.obstacles.lambda_px, 2.5);
    EXPECT_EQ(config.pipeline.motion.lambda_px, 2.5);
    EXPECT_EQ(Config{}.pipeline.motion.lambda_px, Config{}.pipeline.obstacles.lambda_px);
}

TEST(Config, CycleImagesIsANumberOrAuto) {
    EXPECT_EQ(with("motion.cycle_images", "6").pipeline.rate.cycle_images, 6);
    Config config = with("motion.cycle_images", "6");
    set_config_value(config, "motion.cycle_images", "auto");
    EXPECT_EQ(config.pipeline.rate.cycle_images, 0);
    EXPECT_EQ(error_of("motion.cycle_images", "0"),
              "motion.cycle_images = 0: is out of range; allowed: 1 .. 16, or auto");
}

TEST(Config, RecordedTakesAnOverrideBack) {
    Config config = with("camera.height_m", "1.65");
    set_config_value(config, "camera.distortion", "-0.3, 0.1, 0, 0, 0.01");
    EXPECT_EQ(config.camera.distortion, (std::array<double, 5>{-0.3, 0.1, 0, 0, 0.01}));
    set_config_value(config, "camera.height_m", "recorded");
    set_config_value(config, "camera.distortion", "recorded");
    EXPECT_FALSE(config.camera.height_m.has_value());
    EXPECT_FALSE(config.camera.distortion.has_value());
}

TEST(Config, OutOfRangeNamesKeyValueRangeAndUnit) {
    EXPECT_EQ(error_of("camera.height_m", "-1"),
              "camera.height_m = -1: is out of range; allowed: 0.01 .. 20, or recorded (m)");
    EXPECT_EQ(error_of("flow.blocks", "2001"), "flow.blocks = 2001: is out of range; allowed: 16 .. 2000");
    EXPECT_NE(error_of("camera.height_m", "0"), "");
    EXPECT_NE(error_of("camera.roll_deg", "10.5"), "");
    EXPECT_NE(error_of("flow.blocks", "99999999999999999999"), "");
}

TEST(Config, NumbersMustBeFiniteAndNothingElse) {
    for (const std::string text :
         {"nan", "NaN", "inf", "-inf", "1e999", "", " ", "1,5", "1.5m", "0x10", "one", "1 2"})
        EXPECT_NE(error_of("obstacles.tau_px", text), "") << text;
    for (const std::string text : {"350.5", "3e2", "", "auto"})
        EXPECT_NE(error_of("flow.blocks", text), "") << text;
    EXPECT_NE(error_of("camera.height_m", "nan").find("is not a finite number"), std::string::npos);
}

TEST(Config, AFailedValueChangesNothing) {
    Config config;
    EXPECT_THROW(set_config_value(config, "camera.distortion", "1 2 3 4 5000"), ConfigError);
    EXPECT_THROW(set_config_value(config, "obstacles.lambda_px", "1000"), ConfigError);
    EXPECT_THROW(set_config_value(config, "camera.camera_label", ""), ConfigError);
    EXPECT_EQ(dump_config(config), dump_config(Config{}));
}

TEST(Config, WordsAreListedWhenNoneFits) {
    EXPECT_EQ(error_of("flow.subpixel", "lk"),
              "flow.subpixel = lk: is none of the words; allowed: none | v | parabola");
    EXPECT_NE(error_of("flow.matcher", "ssd").find("allowed: sad | lk"), std::string::npos);
}

TEST(Config, UnknownKeyNamesTheNearestKnownOne) {
    const auto nearest = [](const std::string& key) {
        const std::string error = error_of(key, "1");
        const auto begin = error.find("known key is ") + 13;
        return error.substr(begin, error.find(' ', begin) - begin);
    };
    EXPECT_EQ(nearest("camera.hieght_m"), "camera.height_m");
    EXPECT_EQ(nearest("camera.HEIGHT_M"), "camera.height_m");
    EXPECT_EQ(nearest("motion.lambda_px"), "obstacles.lambda_px");
    EXPECT_EQ(nearest("flow.block"), "flow.blocks");
    EXPECT_EQ(nearest("resolution"), "map.resolution_m");
    EXPECT_EQ(nearest("obstacles.range_m"), "obstacles.range_max_m");
    EXPECT_EQ(nearest("camra.pitch_deg"), "camera.pitch_deg");
    EXPECT_NE(error_of("", "1"), "");
    EXPECT_EQ(error_of("camera.focal_px", "1").find("unknown key camera.focal_px;"), 0U);
}

TEST(Config, MarkdownHasARowPerKeyAndNoStrayColumn) {
    const std::string text = document_config();
    EXPECT_NE(text.find("| flow.subpixel | v | none \\| v \\| parabola |"), std::string::npos);
    const auto rows = std::count(text.begin(), text.end(), '\n');
    EXPECT_EQ(static_cast<std::size_t>(rows), config_keys().size() + 2);
}

TEST(Config, ALocalMapOfTooManyCellsIsRefused) {
    Config config;
    EXPECT_NO_THROW(check_map(config));
    config.map.size_m = 100.0;
    config.map.resolution_m = 0.02;
    try {
        check_map(config);
        FAIL() << "was taken";
    } catch (const ConfigError& error) {
        EXPECT_EQ(
            std::string(error.what()),
            "map.size_m = 100: with map.resolution_m = 0.02 these are 5000 cells across; allowed: up to "
            "2000, that is map.size_m <= 40");
    }
}

TEST(Config, ARobotWithoutRoomInTheLocalMapIsRefused) {
    Config config;
    EXPECT_NO_THROW(check_navigation(config));
    config.map.size_m = 2.0;
    config.navigation.robot.footprint_m = {{-1.5, -0.3}, {1.5, -0.3}, {1.5, 0.3}, {-1.5, 0.3}};
    try {
        check_navigation(config);
        FAIL() << "was taken";
    } catch (const ConfigError& error) {
        EXPECT_EQ(std::string(error.what()).rfind("map.size_m = 2: too small for navigation.footprint_m", 0),
                  0U);
    }
}

}  // namespace
}  // namespace flownav::config
