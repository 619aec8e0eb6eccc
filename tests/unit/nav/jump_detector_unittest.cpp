#include "flownav/nav/jump_detector.h"

#include <gtest/gtest.h>

#include <limits>

namespace flownav::nav {
namespace {

constexpr double slack_m = 0.05;
constexpr double slack_rad = 0.1;
constexpr double time_s = 0.2;
constexpr double bit = 1e-6;

bool jumps(const RobotModel& robot, const Pose2& from, const Pose2& T_from_to) {
    return JumpDetector(robot, slack_m, slack_rad).is_jump(from, compose(from, T_from_to), time_s);
}

TEST(JumpDetector, TheLimitOfTheWayIsOneAndAHalfTimesTheTopSpeedAndTheSlack) {
    const RobotModel robot;  // 0.4 m/s
    const double limit_m = 1.5 * 0.4 * time_s + slack_m;
    for (const Pose2& from : {Pose2{}, Pose2{3.0, -2.0, 2.5}}) {
        for (const double side : {1.0, -1.0}) {
            EXPECT_FALSE(jumps(robot, from, {side * (limit_m - bit), 0.0, 0.0}));
            EXPECT_TRUE(jumps(robot, from, {side * (limit_m + bit), 0.0, 0.0}));
            EXPECT_FALSE(jumps(robot, from, {0.0, side * (limit_m - bit), 0.0}));
            EXPECT_TRUE(jumps(robot, from, {0.0, side * (limit_m + bit), 0.0}));
        }
    }
}

TEST(JumpDetector, TheLimitOfTheTurnIsOneAndAHalfTimesTheFastestTurnAndTheSlack) {
    const RobotModel robot;  // 0.9 rad/s
    const double limit_rad = 1.5 * 0.9 * time_s + slack_rad;
    for (const double side : {1.0, -1.0}) {
        const Pose2 across_the_wrap{1.0, 1.0, side * 3.1};
        EXPECT_FALSE(jumps(robot, across_the_wrap, {0.0, 0.0, side * (limit_rad - bit)}));
        EXPECT_TRUE(jumps(robot, across_the_wrap, {0.0, 0.0, side * (limit_rad + bit)}));
    }
}

TEST(JumpDetector, ARobotThatIsFasterBackwardMayMoveThatFar) {
    RobotModel robot;
    robot.v_back_mps = 1.0;
    EXPECT_FALSE(jumps(robot, {}, {-0.3, 0.0, 0.0}));
    EXPECT_TRUE(jumps(RobotModel(), {}, {-0.3, 0.0, 0.0}));
}

TEST(JumpDetector, APoseThatIsNotFiniteIsAJump) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Pose2& broken : {Pose2{nan, 0.0, 0.0}, Pose2{0.0, nan, 0.0}, Pose2{0.0, 0.0, nan}})
        EXPECT_TRUE(JumpDetector(RobotModel(), slack_m, slack_rad).is_jump({}, broken, time_s));
}

TEST(PlausibleMotion, IsLimitedToOneAndAHalfTimesTheModel) {
    const RobotModel robot;  // 0.4 m/s forward, 0.15 m/s backward, 0.9 rad/s
    const MotionCommand fast = plausible_motion(robot, {5.0, 9.0});
    EXPECT_DOUBLE_EQ(fast.v_mps, 0.6);
    EXPECT_DOUBLE_EQ(fast.omega_radps, 1.35);
    const MotionCommand back = plausible_motion(robot, {-5.0, -9.0});
    EXPECT_DOUBLE_EQ(back.v_mps, -0.225);
    EXPECT_DOUBLE_EQ(back.omega_radps, -1.35);
    EXPECT_EQ(plausible_motion(robot, {0.5, -1.0}).v_mps, 0.5);
    EXPECT_EQ(plausible_motion(robot, {0.5, -1.0}).omega_radps, -1.0);
}

}  // namespace
}  // namespace flownav::nav
