#include <gtest/gtest.h>

#include <algorithm>

#include "course.h"
#include "flownav/nav/make_navigator.h"

namespace flownav::nav {
namespace {

/// Drives straight ahead at a share of the fastest speed.
class Straight : public Navigator {
  public:
    explicit Straight(const NavigatorOptions& options) : v_mps_(0.5 * options.robot.v_max_mps) {}
    Decision decide(const Situation&, const Eigen::Vector2d&) override {
        return {{v_mps_, 0.0}, 1.0, false, "ahead"};
    }

  private:
    double v_mps_;
};

TEST(OwnNavigator, ARegisteredNavigatorDrivesByItsName) {
    register_navigator("straight", [](const NavigatorOptions& o) { return std::make_unique<Straight>(o); });
    NavigatorOptions options;
    options.robot.v_max_mps = 0.8;
    const auto navigator = make_navigator("straight", options);
    const Drive result = drive(*navigator, options.robot, {}, {}, {2.0, 0.0}, 10.0);
    EXPECT_TRUE(result.reached);
    EXPECT_NEAR(result.v_max_mps, 0.4, 0.01);
    EXPECT_EQ(result.decisions.front().why, "ahead");
    EXPECT_EQ(navigator_names().back(), "straight");
}

TEST(OwnNavigator, AnUnknownNameIsRefusedWithTheKnownOnes) {
    try {
        make_navigator("sails", {});
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("'sails'; known: lanes | reactive"), std::string::npos);
    }
}

}  // namespace
}  // namespace flownav::nav
