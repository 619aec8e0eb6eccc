#include "flownav/config/config_section.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

namespace flownav::config {
namespace {

TEST(ConfigSection, ReadsItsKeysFromASectionOfAnyNameAmongOthers) {
    const mrpt::config::CConfigFileMemory ini(
        std::string("[eye]\ndriver = SomeSensor\nblocks = 120 // few\nprocess_rate = 25\n"));
    Config config;
    ConfigSection(config, "flow").loadFromConfigFile(ini, "eye");
    EXPECT_EQ(config.pipeline.flow.blocks, 120);
}

TEST(ConfigSection, ThrowsOnAValueThatCannotBeUsed) {
    const mrpt::config::CConfigFileMemory ini(std::string("[eye]\nblocks = many\n"));
    Config config;
    EXPECT_THROW(ConfigSection(config, "flow").loadFromConfigFile(ini, "eye"), ConfigError);
}

TEST(ConfigSection, WhatItSavesItLoads) {
    Config saved;
    set_config_value(saved, "map.resolution_m", "0.25");
    mrpt::config::CConfigFileMemory ini;
    ConfigSection(saved, "map").saveToConfigFile(ini, "map");
    Config loaded;
    ConfigSection(loaded, "map").loadFromConfigFile(ini, "map");
    EXPECT_EQ(dump_config(loaded), dump_config(saved));
}

}  // namespace
}  // namespace flownav::config
