#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/nav/reactive/CLogFileRecord.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <filesystem>

#include "course.h"
#include "flownav/nav/make_navigator.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

RobotModel robot_of(double v_max_mps) {
    RobotModel robot;
    robot.v_max_mps = v_max_mps;
    robot.omega_max_radps = 1.5;
    robot.alpha_radps2 = 4.0;
    return robot;
}

NavigatorOptions options_of(const RobotModel& robot = robot_of(0.5)) {
    NavigatorOptions options;
    options.robot = robot;
    options.resolution_m = Course().cell_m;
    return options;
}

class Navigators : public testing::TestWithParam<const char*> {
  protected:
    Drive run(const Course& course, const Vector2d& waypoint_m, double seconds,
              const RobotModel& robot = robot_of(0.5), double period_s = 0.2) const {
        NavigatorOptions options = options_of(robot);
        options.period_s = period_s;
        const auto navigator = make_navigator(GetParam(), options);
        return drive(*navigator, robot, course, {}, waypoint_m, seconds, period_s);
    }
};

INSTANTIATE_TEST_SUITE_P(Both, Navigators, testing::Values("lanes", "reactive"), [](const auto& test) {
    return std::string(test.param) == "lanes" ? "Lanes" : "Reactive";
});

TEST_P(Navigators, OverFreeGroundTheyGoStraight) {
    const Drive drive = run({}, {4.0, 0.0}, 15.0);
    EXPECT_TRUE(drive.reached);
    EXPECT_NEAR(drive.end.y_m, 0.0, 0.05);
    EXPECT_GT(drive.v_max_mps, 0.4);
}

TEST_P(Navigators, AroundAWallOfPostsTheyReachTheWayPointWithoutContact) {
    const auto navigator = make_navigator(GetParam(), options_of());
    for (const double side : {1.0, -1.0}) {
        Course course;
        course.add_wall({2.0, -0.6 * side}, {2.0, 0.5 * side});
        const Drive past = drive(*navigator, robot_of(0.5), course, {}, {4.0, 0.0}, 40.0);
        EXPECT_TRUE(past.reached);
        EXPECT_GT(past.clearance_m, 0.02);
    }
}

TEST_P(Navigators, BeforeAWallTheyStopFromEverySpeed) {
    for (const double v_mps : {0.3, 1.5}) {
        Course course;
        course.add_wall({2.5, -2.5}, {2.5, 2.5});
        const Drive drive = run(course, {5.0, 0.0}, 2.0 + 2.5 / v_mps, robot_of(v_mps));
        EXPECT_GT(drive.clearance_m, 0.01) << v_mps;
        EXPECT_LT(drive.clearance_m, 1.0) << v_mps;
        EXPECT_GT(drive.v_max_mps, 0.6 * v_mps);
    }
}

TEST_P(Navigators, AWayPointBehindIsReached) {
    const Drive drive = run({}, {-2.0, 0.1}, 30.0);
    EXPECT_TRUE(drive.reached);
}

TEST_P(Navigators, WithShorterPeriodsTheyDriveAsWell) {
    Course course;
    course.add(1.5, 0.05);
    const Drive drive = run(course, {3.0, 0.0}, 20.0, robot_of(0.5), 0.1);
    EXPECT_TRUE(drive.reached);
    EXPECT_GT(drive.clearance_m, 0.03);
}

TEST_P(Navigators, WithoutKnowledgeOfObstaclesTheyStandAndGoOnWhenItReturns) {
    const auto navigator = make_navigator(GetParam(), options_of());
    const auto map = Course().local_map({});
    Situation situation{0.0, {}, {}, &map, true};
    EXPECT_GT(navigator->decide(situation, {3.0, 0.0}).command.v_mps, 0.0);
    for (const double time_s : {0.2, 0.4}) {
        situation.time_s = time_s;
        situation.obstacles_known = false;
        const Decision decision = navigator->decide(situation, {3.0, 0.0});
        EXPECT_EQ(decision.command.v_mps, 0.0);
        EXPECT_EQ(decision.command.omega_radps, 0.0);
        EXPECT_EQ(decision.why, "obstacles are not known");
        EXPECT_FALSE(decision.stuck);
    }
    situation.time_s = 0.6;
    situation.obstacles_known = true;
    EXPECT_GT(navigator->decide(situation, {3.0, 0.0}).command.v_mps, 0.0);
}

TEST_P(Navigators, UnseenGroundSlowsThem) {
    Course unseen;
    unseen.p_elsewhere = 0.5F;
    const auto navigator = make_navigator(GetParam(), options_of());
    const auto map = unseen.local_map({});
    const Decision decision = navigator->decide({0.0, {}, {0.5, 0.0}, &map, true}, {3.0, 0.0});
    EXPECT_GT(decision.command.v_mps, 0.0);
    EXPECT_LE(decision.command.v_mps, LaneParams().unseen_mps + 0.02);
}

TEST_P(Navigators, EnclosedTheyAreStuck) {
    Course course;
    course.add_wall({0.44, -0.4}, {0.44, 0.4});
    course.add_wall({-0.4, 0.40}, {0.4, 0.40});
    course.add_wall({-0.4, -0.40}, {0.4, -0.40});
    course.add_wall({-0.44, -0.4}, {-0.44, 0.4});
    const auto navigator = make_navigator(GetParam(), options_of());
    const auto map = course.local_map({});
    Decision decision;
    for (int i = 0; i < 3; ++i) decision = navigator->decide({0.2 * i, {}, {}, &map, true}, {3.0, 0.0});
    EXPECT_TRUE(decision.stuck) << decision.why;
    EXPECT_EQ(decision.command.v_mps, 0.0);
}

TEST_P(Navigators, AtTheWayPointTheyStandAndAreNotStuck) {
    const auto navigator = make_navigator(GetParam(), options_of());
    const auto map = Course().local_map({});
    navigator->decide({0.0, {}, {}, &map, true}, {1.0, 0.0});
    const Decision decision = navigator->decide({0.2, {}, {}, &map, true}, {0.02, 0.0});
    EXPECT_EQ(decision.command.v_mps, 0.0);
    EXPECT_FALSE(decision.stuck);
    EXPECT_GT(navigator->decide({0.4, {}, {}, &map, true}, {1.0, 0.0}).command.v_mps, 0.0);
}

TEST_P(Navigators, ANewWayPointEveryTimeStopsNothing) {
    const auto navigator = make_navigator(GetParam(), options_of());
    const auto map = Course().local_map({});
    for (int i = 0; i < 20; ++i) {
        const Pose2 at{0.1 * i, 0.0, 0.0};
        const Decision decision =
            navigator->decide({0.2 * i, at, {0.5, 0.0}, &map, true}, {at.x_m + 1.5, 0.01 * (i % 3)});
        EXPECT_GT(decision.command.v_mps, 0.4) << i;
    }
}

TEST_P(Navigators, TheSameDriveIsTheSameToTheLastDigit) {
    Course course;
    course.add(1.5, 0.05);
    course.add(2.2, -0.6);
    const Drive first = run(course, {3.5, 0.2}, 6.0);
    const Drive second = run(course, {3.5, 0.2}, 6.0);
    ASSERT_EQ(first.decisions.size(), second.decisions.size());
    for (std::size_t i = 0; i < first.decisions.size(); ++i) {
        EXPECT_EQ(first.decisions[i].command.v_mps, second.decisions[i].command.v_mps);
        EXPECT_EQ(first.decisions[i].command.omega_radps, second.decisions[i].command.omega_radps);
    }
}

TEST_P(Navigators, TheySayNothingOnTheConsole) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    {
        const auto navigator = make_navigator(GetParam(), options_of());
        const auto map = Course().local_map({});
        navigator->decide({0.0, {}, {}, &map, true}, {3.0, 0.0});
        navigator->decide({0.2, {}, {}, &map, false}, {3.0, 0.0});
        navigator->decide({0.4, {}, {}, &map, true}, {0.01, 0.0});
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_P(Navigators, TheNavlogCanBeReadBack) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("navlog_" + std::string(GetParam()));
    std::filesystem::remove_all(folder);
    {
        NavigatorOptions options = options_of();
        options.navlog_dir = folder.string();
        Course course;
        course.add(1.5, 0.05);
        const auto navigator = make_navigator(GetParam(), options);
        drive(*navigator, options.robot, course, {}, {3.0, 0.0}, 1.0);
    }
    mrpt::io::CFileGZInputStream file((folder / "log_000.reactivenavlog").string());
    ASSERT_TRUE(file.fileOpenCorrectly());
    auto archive = mrpt::serialization::archiveFrom(file);
    for (int i = 0; i < 5; ++i) {
        const auto record = archive.ReadObject<mrpt::nav::CLogFileRecord>();
        EXPECT_GT(record->WS_Obstacles.size(), 0U);
        // The viewer takes the paths from the generators of the first record.
        EXPECT_EQ(static_cast<bool>(record->infoPerPTG.at(0).ptg), i == 0);
        EXPECT_EQ(record->robotShape_x.size(), 4);
        ASSERT_TRUE(record->cmd_vel);
        EXPECT_GT(record->cmd_vel->getVelCmdElement(0), 0.0);
    }
}

TEST_P(Navigators, TheWatchdogIsStartedAndFed) {
    class Watchdog : public WatchdogSink {
      public:
        void start_watchdog(double period_s) override { period_s_ = period_s; }
        void stop_watchdog() override { period_s_ = 0.0; }
        void alive() override { ++alive_; }
        double period_s_ = 0.0;
        int alive_ = 0;
    } watchdog;
    NavigatorOptions options = options_of();
    options.watchdog = &watchdog;
    const auto navigator = make_navigator(GetParam(), options);
    const auto map = Course().local_map({});
    navigator->decide({0.0, {}, {}, &map, true}, {3.0, 0.0});
    navigator->decide({0.2, {}, {}, &map, true}, {3.0, 0.0});
    EXPECT_EQ(watchdog.period_s_, 1.0);
    EXPECT_GE(watchdog.alive_, 2);
}

TEST_P(Navigators, ASimulatedClockFollowsTheSituation) {
    mrpt::Clock::setSimulatedTime(mrpt::Clock::fromDouble(1.0));
    mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
    const auto navigator = make_navigator(GetParam(), options_of());
    const auto map = Course().local_map({});
    navigator->decide({42.0, {}, {}, &map, true}, {3.0, 0.0});
    EXPECT_NEAR(mrpt::Clock::nowDouble(), 42.0, 1e-6);
    mrpt::Clock::setActiveClock(mrpt::Clock::Realtime);
}

/// Two walls with a gap in between, three metres ahead.
Course gap(double width_m) {
    Course course;
    for (const double side : {1.0, -1.0})
        course.add_wall({3.0, side * (width_m / 2 + 0.075)}, {3.0, side * 4.5});
    return course;
}

TEST(LaneNavigator, AGapAsWideAsTheRobotAndTenCentimetresIsPassed) {
    const RobotModel robot = robot_of(0.5);
    const auto navigator = make_navigator("lanes", options_of(robot));
    const Drive through = drive(*navigator, robot, gap(0.5), {}, {5.0, 0.0}, 40.0);
    EXPECT_TRUE(through.reached);
    EXPECT_GT(through.clearance_m, 0.0);
}

TEST(LaneNavigator, ARobotThatIsTooWideStaysOutOfTheGap) {
    RobotModel wide = robot_of(0.5);
    wide.footprint_m = {{0.25, 0.3}, {-0.25, 0.3}, {-0.25, -0.3}, {0.25, -0.3}};
    const auto navigator = make_navigator("lanes", options_of(wide));
    const Drive before = drive(*navigator, wide, gap(0.5), {}, {5.0, 0.0}, 25.0);
    EXPECT_FALSE(before.reached);
    EXPECT_GT(before.clearance_m, 0.01);
}

TEST(LaneNavigator, ItDoesNotDither) {
    const RobotModel robot = robot_of(0.5);
    Course course;
    course.add(2.0, 0.0);  // left and right are equivalent
    const auto navigator = make_navigator("lanes", options_of(robot));
    const Drive past = drive(*navigator, robot, course, {}, {4.0, 0.0}, 25.0);
    EXPECT_TRUE(past.reached);
    EXPECT_LE(past.turns, 4);
}

}  // namespace
}  // namespace flownav::nav
