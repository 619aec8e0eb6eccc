#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "flownav/config/config.h"
#include "flownav/config/config_section.h"

namespace flownav::config {
namespace {

namespace fs = std::filesystem;

/// What `action` writes to stderr.
template <class Action>
std::string said_by(const Action& action) {
    ::testing::internal::CaptureStderr();
    action();
    return ::testing::internal::GetCapturedStderr();
}

/// Loads an ini of this text.
Config load(const std::string& text) {
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    const fs::path file = fs::path(::testing::TempDir()) / ("flownav_renamed_" + test + ".ini");
    std::ofstream(file) << text;
    Config config;
    load_config_file(config, file.string());
    fs::remove(file);
    return config;
}

TEST(Renamed, EarlierNamesSetTheKeysOfToday) {
    Config config;
    set_config_value(config, "flow.blind_cone", "0.08");
    set_config_value(config, "navigation.plan", "stuck");
    set_config_value(config, "navigation.decide_every_s", "0.125");
    EXPECT_EQ(config.pipeline.flow.focus_exclusion, 0.08);
    EXPECT_EQ(config.recovery.replan, nav::ReplanPolicy::WhenStuck);
    EXPECT_EQ(config.navigation.controller_period_s, 0.125);
    set_config_value(config, "navigation.replan", "never");
    EXPECT_EQ(config.recovery.replan, nav::ReplanPolicy::Never);
    set_config_value(config, "navigation.replan", "when_stuck");
    EXPECT_EQ(config.recovery.replan, nav::ReplanPolicy::WhenStuck);
}

// In a process of its own, as the warning comes once a process.
TEST(RenamedDeathTest, EachEarlierNameIsOneWarningThatNamesThePresentOne) {
    const auto set_twice = [] {
        Config config;
        for (int i = 0; i < 2; ++i) {
            set_config_value(config, "flow.blind_cone", "0.08");
            set_config_value(config, "navigation.plan", "stuck");
            set_config_value(config, "navigation.controller_period_s", "0.1");
        }
        std::exit(0);
    };
    ::testing::GTEST_FLAG(death_test_style) = "threadsafe";
    EXPECT_EXIT(set_twice(), ::testing::ExitedWithCode(0),
                "^flownav: warning: the key flow.blind_cone is now called flow.focus_exclusion[^\n]*\n"
                "flownav: warning: the key navigation.plan is now called navigation.replan[^\n]*\n"
                "flownav: warning: navigation.replan = stuck is now written navigation.replan = when_stuck"
                "[^\n]*\n$");
}

TEST(Renamed, AnIniOfTheLastVersionIsRead) {
    const Config config =
        load("[flow]\nblind_cone = 0.1\n[navigation]\nplan = stuck\ndecide_every_s = 0.5\n");
    EXPECT_EQ(config.pipeline.flow.focus_exclusion, 0.1);
    EXPECT_EQ(config.recovery.replan, nav::ReplanPolicy::WhenStuck);
    EXPECT_EQ(config.navigation.controller_period_s, 0.5);
}

TEST(Renamed, AKeySetByBothNamesIsSetTwice) {
    try {
        load("[flow]\nblind_cone = 0.1\nfocus_exclusion = 0.2\n");
        FAIL() << "was taken";
    } catch (const ConfigError& error) {
        EXPECT_NE(std::string(error.what()).find(":3: key flow.focus_exclusion is set a second time"),
                  std::string::npos)
            << error.what();
    }
}

TEST(Renamed, ASectionOfMrptIsReadByEarlierNames) {
    const mrpt::config::CConfigFileMemory ini(std::string("[eye]\nblind_cone = 0.1\nblocks = 120\n"));
    Config config;
    ConfigSection(config, "flow").loadFromConfigFile(ini, "eye");
    EXPECT_EQ(config.pipeline.flow.focus_exclusion, 0.1);
    EXPECT_EQ(config.pipeline.flow.blocks, 120);
}

TEST(Renamed, AnUnusableValueIsReportedByThePresentName) {
    Config config;
    try {
        set_config_value(config, "navigation.plan", "often");
        FAIL() << "was taken";
    } catch (const ConfigError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "navigation.replan = often: is none of the words; allowed: always | when_stuck | never");
    }
}

TEST(Renamed, OutputsHaveThePresentNamesOnly) {
    Config config;
    set_config_value(config, "flow.blind_cone", "0.08");
    set_config_value(config, "navigation.plan", "stuck");
    EXPECT_EQ(dump_changes(config), "[flow]\nfocus_exclusion = 0.08\n[navigation]\nreplan = when_stuck\n");
}

TEST(Renamed, PresentNamesStayAndNoneIsAnEarlierOne) {
    std::set<std::string> present;
    for (const ConfigKey& key : config_keys()) present.insert(key.full_name());
    std::size_t earlier_names = 0;
    for (const ConfigKey& key : config_keys()) {
        EXPECT_EQ(present_setting({key.full_name(), key.default_value}).key, key.full_name());
        EXPECT_EQ(present_setting({key.full_name(), key.default_value}).value, key.default_value);
        for (const std::string& earlier : key.earlier_names) {
            ++earlier_names;
            EXPECT_EQ(present.count(earlier), 0U) << earlier;
            EXPECT_EQ(present_setting({earlier, "1"}).key, key.full_name());
        }
    }
    EXPECT_EQ(earlier_names, 3U);
    EXPECT_EQ(present_setting({"flow.no_such_key", "1"}).key, "flow.no_such_key");
}

TEST(Renamed, PresentNamesWarnOfNothing) {
    EXPECT_EQ(said_by([] {
                  Config config;
                  for (const ConfigKey& key : config_keys())
                      set_config_value(config, key.full_name(), key.default_value);
              }),
              "");
}

}  // namespace
}  // namespace flownav::config
