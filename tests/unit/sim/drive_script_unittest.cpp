#include "flownav/sim/drive_script.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"

namespace flownav::sim {
namespace {

Pose2 end_of(const std::string& script, const Pose2& start = {}) {
    const TimedPath path = drive_script(script, RobotModel{}, start);
    return path.at(path.end_s());
}

void expect_pose(const Pose2& pose, double x_m, double y_m, double yaw_deg, double tolerance_m = 2e-3) {
    EXPECT_NEAR(pose.x_m, x_m, tolerance_m);
    EXPECT_NEAR(pose.y_m, y_m, tolerance_m);
    EXPECT_NEAR(wrap_angle(pose.yaw_rad - yaw_deg * degree_rad), 0.0, 1e-6);
}

TEST(DriveScript, DrivesForwardAsFarAsItSays) {
    expect_pose(end_of("forward 3"), 3.0, 0.0, 0.0);
    expect_pose(end_of("forward 0.05"), 0.05, 0.0, 0.0);
}

TEST(DriveScript, DrivesBack) {
    expect_pose(end_of("back 0.5"), -0.5, 0.0, 0.0);
}

TEST(DriveScript, TurnsOnTheSpot) {
    expect_pose(end_of("left 90"), 0.0, 0.0, 90.0, 1e-9);
    expect_pose(end_of("right 33"), 0.0, 0.0, -33.0, 1e-9);
    expect_pose(end_of("left 2"), 0.0, 0.0, 2.0, 1e-9);
}

TEST(DriveScript, StepsFollowEachOther) {
    expect_pose(end_of("forward 1; left 90\nforward 2; right 90 ; forward 1;"), 2.0, 2.0, 0.0, 5e-3);
    expect_pose(end_of("forward 1", {2.0, 3.0, M_PI / 2}), 2.0, 4.0, 90.0);
}

TEST(DriveScript, ACurveTurnsByItsAngleAboutItsRadius) {
    // Smooth ends of the curve shift it by a few centimetres.
    const Pose2 left = end_of("forward 1; left 90 2; forward 1");
    expect_pose(left, 3.0, 3.0, 90.0, 0.1);
    const Pose2 right = end_of("forward 1; right 90 2; forward 1");
    expect_pose(right, 3.0, -3.0, -90.0, 0.1);
}

TEST(DriveScript, DoesNotStopBetweenForwardAndACurve) {
    const TimedPath path = drive_script("forward 1; left 90 2; forward 1", RobotModel{}, {});
    for (int i = 20; i * 0.05 < path.end_s() - 0.5; ++i) {
        const double t_s = i * 0.05;
        const Pose2 moved = compose(inverse(path.at(t_s)), path.at(t_s + 0.01));
        EXPECT_NEAR(moved.x_m, 0.004, 1e-6) << t_s;
    }
}

TEST(DriveScript, KeepsTheLimitsOfTheRobot) {
    const RobotModel robot;
    const TimedPath path = drive_script("forward 1; left 45; right 90 1; back 0.4; wait 1", robot, {});
    double v_mps = 0.0;
    double omega_radps = 0.0;
    for (int i = 0; i * 0.01 < path.end_s(); ++i) {
        const Pose2 moved = compose(inverse(path.at(i * 0.01)), path.at((i + 1) * 0.01));
        EXPECT_LE(std::abs(moved.x_m / 0.01 - v_mps), robot.brake_mps2 * 0.0101 + 1e-6) << i;
        EXPECT_LE(std::abs(moved.yaw_rad / 0.01 - omega_radps), robot.alpha_radps2 * 0.0101 + 1e-6) << i;
        v_mps = moved.x_m / 0.01;
        omega_radps = moved.yaw_rad / 0.01;
    }
}

TEST(DriveScript, SpeedAndTurnHoldForWhatFollows) {
    const TimedPath slow = drive_script("speed 0.1; forward 2", RobotModel{}, {});
    const TimedPath fast = drive_script("speed 0.4; forward 2", RobotModel{}, {});
    EXPECT_NEAR(slow.end_s(), 20.0, 0.5);
    EXPECT_NEAR(fast.end_s(), 5.6, 0.5);
    EXPECT_NEAR(drive_script("turn 10; left 90", RobotModel{}, {}).end_s(), 9.0, 0.3);
}

TEST(DriveScript, NamesTheStepThatGoesWrong) {
    const auto complaint = [](const std::string& script) {
        try {
            drive_script(script, RobotModel{}, {});
        } catch (const PathError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(complaint(" ; "), "the script is empty");
    EXPECT_NE(complaint("forward 1; sideways 2").find("\"sideways 2\""), std::string::npos);
    EXPECT_NE(complaint("forward 1e9").find("longer than an hour"), std::string::npos);
    EXPECT_NE(complaint("left 1e300").find("longer than an hour"), std::string::npos);
    EXPECT_NE(complaint("forward x").find("x is not a number above 0"), std::string::npos);
    EXPECT_NE(complaint("forward -1").find("not a number above 0"), std::string::npos);
    EXPECT_NE(complaint("forward").find("needs one number"), std::string::npos);
    EXPECT_NE(complaint("left 1 2 3").find("at most a radius"), std::string::npos);
    EXPECT_NE(complaint("speed 2").find("fastest is 0.4 m/s"), std::string::npos);
    EXPECT_NE(complaint("turn 90").find("fastest is"), std::string::npos);
    EXPECT_NE(complaint("left 90 0.1").find("too narrow"), std::string::npos);
}

}  // namespace
}  // namespace flownav::sim
