#include "flownav/nav/guard.h"

#include <gtest/gtest.h>

#include <random>

#include "guard_drive.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double reaction_s = 0.3;
constexpr double tick_s = 0.02;

/// Adds wall points 5 cm apart along a segment.
void build(Drive& drive, const Vector2d& from_m, const Vector2d& to_m) {
    const int cells = static_cast<int>(std::ceil((to_m - from_m).norm() / 0.05));
    for (int i = 0; i <= cells; ++i)
        drive.walls_m.emplace_back(from_m + (to_m - from_m) * i / std::max(1, cells));
}

double distance_to_walls_m(const Drive& drive) {
    double nearest = 1e9;
    for (const Vector2d& wall : drive.walls_m) {
        const Vector2d p = transform(inverse(drive.robot.pose()), wall);
        nearest = std::min(nearest, signed_distance_m(drive.model.footprint_m, p));
    }
    return nearest;
}

/// Time and distance until the robot stands, at most 3 s.
struct Halt {
    double time_s = 0.0;
    double way_m = 0.0;
};

Halt halt(Drive& drive, const std::function<void(Tick&)>& fault) {
    const double begin_s = drive.robot.time_s();
    const Pose2 begin = drive.robot.pose();
    while (drive.robot.time_s() < begin_s + 3.0) {
        drive.go(tick_s, fault);
        if (drive.robot.stands()) break;
    }
    const Pose2 moved = compose(inverse(begin), drive.robot.pose());
    return {drive.robot.time_s() - begin_s, std::hypot(moved.x_m, moved.y_m)};
}

/// A robot at its full speed.
Drive moving() {
    Drive drive;
    drive.go(3.0);
    EXPECT_NEAR(drive.robot.motion().v_mps, 0.4, 1e-9);
    EXPECT_EQ(drive.safety.action, GuardAction::Pass);
    return drive;
}

void expect_stop_and_resume(const std::function<void(Tick&)>& fault, GuardReason reason) {
    Drive drive = moving();
    const Halt stop = halt(drive, fault);
    const RobotModel& robot = drive.model;
    EXPECT_EQ(drive.safety.action, GuardAction::Stop);
    EXPECT_EQ(drive.safety.reason, reason) << drive.safety.why;
    EXPECT_LE(stop.time_s, reaction_s + robot.delay_s + 0.4 / robot.brake_mps2 + 2 * tick_s);
    EXPECT_EQ(drive.guard.events().back().reason, reason);
    EXPECT_FALSE(drive.guard.events().back().why.empty());
    drive.go(3.0, fault);
    drive.go(12.0);
    EXPECT_EQ(drive.safety.action, GuardAction::Pass) << drive.safety.why;
    EXPECT_NEAR(drive.robot.motion().v_mps, 0.4, 1e-9);
}

TEST(Guard, OverSeenGroundEveryCommandPasses) {
    Drive drive;
    drive.go(1.0);
    for (const MotionCommand& wish : {MotionCommand{0.4, 0.0}, MotionCommand{0.3, 0.9},
                                      MotionCommand{-0.1, -0.5}, MotionCommand{0.0, 0.9}}) {
        drive.wish = wish;
        drive.go(1.0);
        EXPECT_EQ(drive.safety.action, GuardAction::Pass) << drive.safety.why;
        EXPECT_EQ(drive.safety.command.v_mps, wish.v_mps);
        EXPECT_EQ(drive.safety.command.omega_radps, wish.omega_radps);
    }
}

TEST(Guard, CommandsBeyondTheRobotsLimitsAreCut) {
    Drive drive;
    drive.wish = {5.0, -7.0};
    drive.go(1.0);
    EXPECT_EQ(drive.safety.command.v_mps, drive.model.v_max_mps);
    EXPECT_EQ(drive.safety.command.omega_radps, -drive.model.omega_max_radps);
}

TEST(Guard, WithoutAnyFieldTheRobotStays) {
    Drive drive;
    drive.go(1.0, [](Tick& tick) { tick.field = false; });
    EXPECT_EQ(drive.robot.pose().x_m, 0.0);
    EXPECT_EQ(drive.safety.reason, GuardReason::SensorStale);
}

TEST(Guard, StopsWhenFieldsStopComing) {
    expect_stop_and_resume([](Tick& tick) { tick.field = false; }, GuardReason::SensorStale);
}

TEST(Guard, AStreamThatComesASecondLateIsStale) {
    expect_stop_and_resume([](Tick& tick) { tick.report.timestamp_s -= 1.0; }, GuardReason::SensorStale);
}

TEST(Guard, StopsWhenTheFieldIsNoPicture) {
    expect_stop_and_resume([](Tick& tick) { tick.report.status = FieldStatus::BadField; },
                           GuardReason::SensorBlind);
}

TEST(Guard, StopsWhenThereAreTooFewVectors) {
    expect_stop_and_resume(
        [](Tick& tick) {
            tick.report.confident = {2, 2, 2, 2};
        },
        GuardReason::SensorBlind);
}

TEST(Guard, StopsWhenHalfTheLensIsCovered) {
    expect_stop_and_resume(
        [](Tick& tick) {
            tick.report.confident = {60, 60, 0, 1};
        },
        GuardReason::SensorBlind);
}

TEST(Guard, StopsWhenTheImageIsFrozen) {
    expect_stop_and_resume(
        [](Tick& tick) {
            tick.report.omega_radps = tick.report.v_mps = 0.0;
            tick.report.v_measured = false;
            tick.report.repeated = true;
        },
        GuardReason::SensorFrozen);
}

TEST(Guard, ACameraThatSendsEveryImageTwiceIsNotFrozen) {
    Drive drive = moving();
    bool again = false;
    drive.go(3.0, [&](Tick& tick) {
        tick.report.repeated = again;
        again = !again;
        EXPECT_EQ(drive.safety.action, GuardAction::Pass) << drive.safety.why;
    });
}

TEST(Guard, StopsWhenTheNavigatorHangs) {
    Drive drive = moving();
    const Halt stop = halt(drive, [](Tick& tick) { tick.proposal_comes = false; });
    EXPECT_EQ(drive.safety.reason, GuardReason::NavigatorSilent);
    EXPECT_LE(stop.time_s, GuardParams().silent_s + 0.1 + 0.4 + 2 * tick_s);
    drive.go(1.5);
    EXPECT_NEAR(drive.robot.motion().v_mps, 0.4, 1e-9);
}

TEST(Guard, StopsWhenOmegaIsLostForLongerThanAMoment) {
    Drive drive = moving();
    const auto lost = [](Tick& tick) { tick.report.status = FieldStatus::Lost; };
    drive.go(0.1, lost);
    EXPECT_EQ(drive.safety.action, GuardAction::Pass);
    drive.go(0.2, lost);
    EXPECT_EQ(drive.safety.reason, GuardReason::OmegaLost);
    drive.go(3.0);
    EXPECT_EQ(drive.safety.action, GuardAction::Pass);
}

TEST(Guard, StopsWhenTheWheelsTellAnotherSpeedThanTheFlow) {
    for (const double factor : {0.0, 0.5, 2.0}) {
        Drive drive = moving();
        drive.go(1.5, [&](Tick& tick) { tick.report.v_mps *= factor; });
        EXPECT_EQ(drive.safety.reason, GuardReason::OdometryContradiction) << factor;
    }
}

TEST(Guard, StopsWhenTheWheelsTellAnotherTurnThanTheFlow) {
    for (const double sign : {1.0, -1.0}) {
        Drive drive = moving();
        drive.go(1.0, [&](Tick& tick) { tick.report.omega_radps += 0.3 * sign; });
        EXPECT_EQ(drive.safety.reason, GuardReason::OdometryContradiction);
    }
}

TEST(Guard, SmallDifferencesOfFlowAndWheelsAreNoContradiction) {
    Drive drive = moving();
    drive.wish = {0.4, 0.6};
    int tick_number = 0;
    drive.go(10.0, [&](Tick& tick) {
        tick.report.v_mps *= ++tick_number % 20 < 10 ? 1.15 : 0.9;
        tick.report.omega_radps *= 1.05;
        EXPECT_NE(drive.safety.reason, GuardReason::OdometryContradiction) << drive.safety.why;
    });
}

TEST(Guard, AJumpOfTheWheelsStopsTheRobotAtOnceAndForAWhile) {
    for (const Pose2& jump : {Pose2{1.0, 0.0, 0.0}, Pose2{0.0, 0.0, 0.6}}) {
        Drive drive = moving();
        const auto jumped = [&](Tick& tick) { tick.odometry = compose(jump, tick.odometry); };
        const auto turned = [&](Tick& tick) { tick.odometry = compose(tick.odometry, jump); };
        const std::function<void(Tick&)> fault =
            jump.yaw_rad != 0.0 ? std::function<void(Tick&)>(turned) : jumped;
        drive.go(tick_s, fault);
        EXPECT_EQ(drive.safety.action, GuardAction::Stop);
        EXPECT_EQ(drive.safety.reason, GuardReason::OdometryContradiction);
        drive.go(15.0, fault);
        EXPECT_EQ(drive.safety.action, GuardAction::Pass) << drive.safety.why;
    }
}

TEST(Guard, AfterADoubtItCrawlsUntilFlowAndWheelsAgree) {
    Drive drive = moving();
    const auto frozen = [](Tick& tick) {
        tick.report.omega_radps = tick.report.v_mps = 0.0;
        tick.report.v_measured = false;
        tick.report.repeated = true;
    };
    drive.go(2.0, frozen);
    const Pose2 before = drive.robot.pose();
    drive.go(20.0, frozen);
    const double probed_m = drive.robot.pose().x_m - before.x_m;
    EXPECT_GT(probed_m, 0.02);  // it probes
    EXPECT_LT(probed_m, 0.4);   // at intervals
    drive.go(10.0);
    EXPECT_NEAR(drive.robot.motion().v_mps, 0.4, 1e-9);
}

TEST(Guard, StandsBeforeAWallAndSaysSo) {
    Drive drive;
    build(drive, {2.0, -1.0}, {2.0, 1.0});
    drive.go(15.0);
    EXPECT_EQ(drive.safety.reason, GuardReason::ObstacleAhead);
    EXPECT_GT(distance_to_walls_m(drive), 0.0);
    EXPECT_LT(distance_to_walls_m(drive), 0.12);  // and no farther than necessary
    drive.wish = {-0.1, 0.0};
    drive.go(1.0);
    EXPECT_EQ(drive.safety.action, GuardAction::Pass) << drive.safety.why;  // it may drive away
}

TEST(Guard, TheSpeedBeforeAWallIsTheOneThatStopsInTime) {
    RobotModel robot;
    robot.v_max_mps = 1.5;
    Drive drive({}, robot);
    drive.wish = {1.5, 0.0};
    build(drive, {3.5, -1.0}, {3.5, 1.0});
    double fastest_mps = 0.0;
    drive.go(10.0, [&](Tick&) {
        const double free_m = 3.5 - 0.25 - drive.robot.pose().x_m;
        EXPECT_LE(stopping_distance_m(robot, drive.robot.motion().v_mps) - 0.1 * drive.robot.motion().v_mps,
                  free_m);
        fastest_mps = std::max(fastest_mps, drive.robot.motion().v_mps);
    });
    EXPECT_GT(fastest_mps, 1.0);
    EXPECT_GT(distance_to_walls_m(drive), 0.0);
}

TEST(Guard, SlowsBeforeGroundThatWasNeverSeen) {
    Drive drive;
    drive.elsewhere = 0.5F;
    drive.go(3.0);
    EXPECT_EQ(drive.safety.reason, GuardReason::UnseenAhead);
    EXPECT_GT(drive.robot.pose().x_m, 0.1);  // it moves to see the ground
    EXPECT_LE(drive.robot.motion().v_mps, GuardParams().collision_checker.crawl_mps + 1e-9);
    drive.go(20.0);
    EXPECT_EQ(drive.safety.action, GuardAction::Stop);  // but not indefinitely
    EXPECT_LT(drive.robot.pose().x_m, GuardParams().crawl_max_m + 0.1);
    drive.wish = {-0.1, 0.0};
    drive.go(1.0);
    EXPECT_LT(drive.robot.motion().v_mps, 0.0);  // back over ground it has driven
}

TEST(Guard, ABlindStripBeforeTheBumperIsCrawledOver) {
    Drive drive;
    // Free ground is visible from half a metre ahead of the bumper.
    drive.go(8.0, [&](Tick& tick) {
        if (tick.map == nullptr) return;
        *tick.map = known_ground(0.5F);
        for (int x = tick.map->x2idx(0.75F); x < tick.map->x2idx(3.0F); ++x) {
            for (int y = tick.map->y2idx(-1.0F); y < tick.map->y2idx(1.0F); ++y)
                tick.map->setCell(x, y, 0.8F);
        }
        if (drive.robot.pose().x_m < 0.3) {
            EXPECT_LE(drive.robot.motion().v_mps, 0.1 + 1e-9);
        }
    });
    EXPECT_NEAR(drive.robot.motion().v_mps, 0.4, 1e-9);  // full speed once the ground is seen
}

TEST(Guard, TurnsInPlaceOnlyWhenTheCornersAreFree) {
    for (const double side : {1.0, -1.0}) {
        Drive drive;
        drive.wish = {0.0, 0.9 * side};
        drive.walls_m = {{0.15, 0.28 * side}};  // beside the robot, within the reach of its corners
        const double before_m = distance_to_walls_m(drive);
        EXPECT_GT(before_m, 0.0);
        drive.go(3.0);
        EXPECT_GT(distance_to_walls_m(drive), 0.0);
        EXPECT_EQ(drive.safety.reason, GuardReason::ObstacleAhead);
    }
}

TEST(Guard, ARobotWithABlindSectorMayTurnAwayAfterStandingForAWhile) {
    Drive drive = moving();
    drive.wish = {0.0, 0.5};
    const auto blank_wall = [](Tick& tick) { tick.report.confident = {0, 60, 60, 60}; };
    drive.go(2.0, blank_wall);
    EXPECT_TRUE(drive.robot.stands());
    drive.go(3.0, blank_wall);
    EXPECT_GT(drive.robot.motion().omega_radps, 0.1);
    EXPECT_EQ(drive.safety.reason, GuardReason::SensorBlind);
    drive.wish = {0.3, 0.0};
    drive.go(2.0, blank_wall);
    EXPECT_TRUE(drive.robot.stands());
}

TEST(Guard, EveryChangeIsOneEvent) {
    Drive drive = moving();
    const std::size_t before = drive.guard.events().size();
    drive.go(2.0, [](Tick& tick) { tick.field = false; });
    EXPECT_EQ(drive.guard.events().size(), before + 1);
    drive.go(3.0);
    EXPECT_EQ(drive.guard.events().size(), before + 2);
    EXPECT_EQ(drive.guard.events().back().action, GuardAction::Pass);
}

TEST(Guard, NothingANavigatorProposesLeadsIntoAWallOfTheMap) {
    double nearest_m = 1e9;
    for (int seed = 0; seed < 15; ++seed) {
        std::mt19937_64 random(static_cast<unsigned>(seed));
        const auto uniform = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
        };
        RobotModel robot;
        robot.v_max_mps = uniform(0.3, 2.0);
        robot.v_back_mps = uniform(0.1, 1.0);
        robot.omega_max_radps = uniform(0.5, 3.0);
        robot.delay_s = uniform(0.0, 0.3);
        robot.brake_mps2 = uniform(0.5, 3.0);
        Drive drive({}, robot);
        const double half_m = uniform(0.5, 1.5);
        build(drive, {-half_m, -half_m}, {half_m, -half_m});
        build(drive, {half_m, -half_m}, {half_m, half_m});
        build(drive, {half_m, half_m}, {-half_m, half_m});
        build(drive, {-half_m, half_m}, {-half_m, -half_m});
        for (int proposal = 0; proposal < 15; ++proposal) {
            drive.wish = {uniform(-2.0, 2.5), proposal % 3 == 0 ? 0.0 : uniform(-3.0, 3.0)};
            drive.go(uniform(0.02, 1.5),
                     [&](Tick&) { nearest_m = std::min(nearest_m, distance_to_walls_m(drive)); });
            ASSERT_GT(distance_to_walls_m(drive), 0.0) << "seed " << seed;
        }
    }
    EXPECT_GT(nearest_m, 0.0);
}

}  // namespace
}  // namespace flownav::nav
