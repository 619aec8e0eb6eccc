#include <gtest/gtest.h>

#include "flownav/config/config.h"
#include "flownav/flow/matcher_registry.h"
#include "flownav/nav/make_navigator.h"

namespace flownav::config {
namespace {

class ShiftedLens : public Lens {
  public:
    std::string name() const override { return "shifted"; }
    bool is_ideal(const LensCoefficients&) const override { return false; }
    Eigen::Vector2d distort(const Eigen::Vector2d& ideal, const LensCoefficients& k) const override {
        return ideal + Eigen::Vector2d(k[0], k[1]);
    }
};

std::string error_of(const std::string& key, const std::string& value) {
    Config config;
    try {
        set_config_value(config, key, value);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "";
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(RegisteredNames, AnUnknownNameIsRefusedWithKeyValueAndTheKnownNames) {
    EXPECT_TRUE(
        says(error_of("flow.matcher", "ssd"), "flow.matcher = ssd: is none of the known names (sad | lk"));
    EXPECT_TRUE(says(error_of("navigation.navigator", "sails"),
                     "navigation.navigator = sails: is none of the known names (lanes | reactive"));
    EXPECT_TRUE(says(error_of("camera.distortion", "wide 1 0 0 0 0"),
                     "camera.distortion = wide 1 0 0 0 0: is none of the known names (brown_conrady"));
}

TEST(RegisteredNames, ANameIsAllowedOnceItIsRegistered) {
    EXPECT_NE(error_of("flow.matcher", "own"), "");
    EXPECT_NE(error_of("navigation.navigator", "own"), "");
    EXPECT_NE(error_of("camera.distortion", "shifted 0.1 0 0 0 0"), "");
    flow::register_matcher("own", [](const flow::FlowParams&, int) { return flow::Matcher(); });
    nav::register_navigator("own", [](const nav::NavigatorOptions&) { return nullptr; });
    register_lens(std::make_shared<ShiftedLens>());
    Config config;
    set_config_value(config, "flow.matcher", "own");
    set_config_value(config, "navigation.navigator", "own");
    set_config_value(config, "camera.distortion", "shifted 0.1 0 0 0 0");
    EXPECT_EQ(config.pipeline.flow.matcher, "own");
    EXPECT_EQ(config.navigation.navigator, "own");
    EXPECT_EQ(config.camera.lens, "shifted");
    EXPECT_EQ(config.camera.distortion, (LensCoefficients{0.1, 0, 0, 0, 0}));
    EXPECT_TRUE(says(dump_changes(config), "distortion = shifted 0.1 0 0 0 0\n"));
    EXPECT_TRUE(says(error_of("flow.matcher", "ssd"), "sad | lk | own"));
    EXPECT_THROW(flow::register_matcher("own", nullptr), std::invalid_argument);
    EXPECT_THROW(nav::register_navigator("another", nullptr), std::invalid_argument);
}

TEST(RegisteredNames, FiveNumbersAreOfTheBuiltInLens) {
    Config config;
    set_config_value(config, "camera.distortion", "0.1 0 0 0 0");
    EXPECT_EQ(config.camera.lens, "brown_conrady");
    EXPECT_TRUE(says(dump_changes(config), "distortion = 0.1 0 0 0 0\n"));
    EXPECT_NE(error_of("camera.distortion", "0.1 0 0 0 0 0"), "");
    EXPECT_NE(error_of("camera.distortion", "brown_conrady 0.1"), "");
}

}  // namespace
}  // namespace flownav::config
