#include "flownav/nav/odometry_watch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flownav::nav {
namespace {

constexpr double field_s = 0.04;
constexpr double odometry_s = 0.02;
constexpr int cycle_fields = 4;
constexpr double circumscribed_m = 0.32015621187164243;  // of the default footprint, 0.5 m x 0.4 m

/// Pose after `time_s` of a steady motion from the identity, in closed form.
Pose2 steady(const MotionCommand& motion, double time_s) {
    const double turn_rad = motion.omega_radps * time_s;
    if (motion.omega_radps == 0.0) return {motion.v_mps * time_s, 0.0, 0.0};
    const double radius_m = motion.v_mps / motion.omega_radps;
    return {radius_m * std::sin(turn_rad), radius_m * (1.0 - std::cos(turn_rad)), turn_rad};
}

/// A watch with wheels and flow that move steadily and independently: fields at 25 Hz in cycles of four,
/// odometry at 50 Hz or less.
struct Drive {
    OdometryWatch watch{RobotModel(), OdometryWatchParams()};
    MotionCommand wheels, flow;
    bool with_odometry = true;
    int odometry_every = 1;
    bool repeats = false;
    bool measures_v = true;
    Pose2 T_odom_begin;  ///< changes with the motion of the wheels and at pose jumps
    double begin_s = 0.0;
    double time_s = 0.0;
    int ticks = 0;

    Pose2 pose() const { return compose(T_odom_begin, steady(wheels, time_s - begin_s)); }
    /// Continues with other motions of wheels and flow.
    void change(const MotionCommand& by_wheels, const MotionCommand& by_flow) {
        T_odom_begin = pose();
        begin_s = time_s;
        wheels = by_wheels;
        flow = by_flow;
    }
    void jump(const Pose2& by) {
        T_odom_begin = compose(pose(), by);
        begin_s = time_s;
    }
    Fault go(double seconds) {
        for (const int end = ticks + static_cast<int>(std::lround(seconds / odometry_s)); ticks < end;) {
            time_s = ++ticks * odometry_s;
            if (with_odometry && ticks % odometry_every == 0) watch.odometry(time_s, pose());
            if (ticks % 2 == 0) watch.sensed(report(ticks / 2));
        }
        return watch.fault(time_s);
    }
    SensorReport report(int field) const {
        SensorReport report;
        report.timestamp_s = field * field_s;
        report.status = FieldStatus::Ok;
        report.end_of_cycle = field % cycle_fields == 0;
        report.omega_radps = flow.omega_radps;
        report.v_mps = flow.v_mps;
        report.v_measured = report.end_of_cycle && measures_v;
        report.repeated = repeats;
        return report;
    }
};

Drive both(const MotionCommand& motion) {
    Drive drive;
    drive.wheels = drive.flow = motion;
    return drive;
}

GuardReason after(const MotionCommand& wheels, const MotionCommand& flow, double seconds) {
    Drive drive = both({0.3, 0.0});
    EXPECT_FALSE(drive.go(2.0));
    drive.change(wheels, flow);
    return drive.go(seconds).reason;
}

TEST(OdometryWatch, SaysNothingWhileFlowAndWheelsTellTheSameMotion) {
    for (const MotionCommand& motion :
         {MotionCommand{0.4, 0.0}, MotionCommand{-0.15, 0.0}, MotionCommand{0.3, 0.6},
          MotionCommand{0.3, -0.6}, MotionCommand{0.0, 0.9}, MotionCommand{0.0, 0.0}}) {
        Drive drive = both(motion);
        for (int i = 0; i < 20; ++i) EXPECT_FALSE(drive.go(0.3)) << motion.v_mps << ' ' << motion.omega_radps;
    }
}

TEST(OdometryWatch, ARobotWithoutOdometryIsNeverDoubted) {
    Drive drive = both({0.4, 0.5});
    drive.with_odometry = false;
    drive.repeats = true;
    EXPECT_FALSE(drive.go(5.0));
    EXPECT_FALSE(drive.watch.is_confirmed_since(0.0));
}

TEST(OdometryWatch, AJumpFartherThanTheRobotCanDriveIsAContradictionForAWhile) {
    // In 20 ms the wheels may move 1.5 * 0.4 m/s * 20 ms + 0.05 m = 0.062 m, and turn 0.127 rad.
    for (const Pose2& by : {Pose2{0.07, 0.0, 0.0}, Pose2{-0.07, 0.0, 0.0}, Pose2{0.0, 0.07, 0.0},
                            Pose2{0.0, 0.0, 0.14}, Pose2{0.0, 0.0, -0.14}}) {
        Drive drive = both({0.0, 0.0});
        drive.go(1.0);
        drive.jump(by);
        EXPECT_EQ(drive.go(odometry_s).reason, GuardReason::OdometryContradiction);
        EXPECT_EQ(drive.go(0.9).reason, GuardReason::OdometryContradiction) << "it is remembered";
        EXPECT_FALSE(drive.go(0.2)) << "but not for ever";
    }
}

TEST(OdometryWatch, AStepThatTheRobotCanDriveIsNoJump) {
    for (const Pose2& by :
         {Pose2{0.055, 0.0, 0.0}, Pose2{-0.055, 0.0, 0.0}, Pose2{0.0, 0.0, 0.11}, Pose2{0.0, 0.0, -0.11}}) {
        Drive drive = both({0.0, 0.0});
        drive.go(1.0);
        drive.jump(by);
        EXPECT_FALSE(drive.go(odometry_s));
    }
}

TEST(OdometryWatch, ALongerPauseAllowsALongerStep) {
    Drive drive = both({0.4, 0.0});
    drive.go(1.0);
    drive.with_odometry = false;
    drive.go(0.4);
    drive.with_odometry = true;
    EXPECT_FALSE(drive.go(odometry_s));  // 0.17 m in 0.42 s
}

TEST(OdometryWatch, SilenceOfTheWheelsIsAContradiction) {
    Drive drive = both({0.4, 0.0});
    drive.go(1.0);
    drive.with_odometry = false;
    EXPECT_FALSE(drive.go(0.48));
    EXPECT_EQ(drive.go(0.04).reason, GuardReason::OdometryContradiction);
    EXPECT_NE(drive.watch.fault(drive.time_s).why.find("no odometry"), std::string::npos);
}

TEST(OdometryWatch, ATurnThatOnlyTheFlowTellsIsAContradictionToEitherSide) {
    for (const double side : {1.0, -1.0}) {
        // |flow - wheels| = 0.3 t exceeds 0.12 + 0.2 * 0.3 t from 0.5 s on.
        EXPECT_EQ(after({0.3, 0.0}, {0.3, 0.3 * side}, 0.44), GuardReason::None);
        EXPECT_EQ(after({0.3, 0.0}, {0.3, 0.3 * side}, 0.60), GuardReason::OdometryContradiction);
    }
}

TEST(OdometryWatch, ATurnThatOnlyTheWheelsTellIsAContradictionToEitherSide) {
    for (const double side : {1.0, -1.0}) {
        EXPECT_EQ(after({0.3, 0.3 * side}, {0.3, 0.0}, 0.44), GuardReason::None);
        EXPECT_EQ(after({0.3, 0.3 * side}, {0.3, 0.0}, 0.60), GuardReason::OdometryContradiction);
    }
}

TEST(OdometryWatch, TurnsToOppositeSidesContradictEachOther) {
    for (const double side : {1.0, -1.0})
        EXPECT_EQ(after({0.0, 0.3 * side}, {0.0, -0.3 * side}, 0.4), GuardReason::OdometryContradiction);
}

TEST(OdometryWatch, AWayOfOtherLengthIsAContradictionForwardAndBackward) {
    for (const double v_mps : {0.4, -0.15}) {
        for (const double factor : {0.0, 0.3, 2.5}) {
            EXPECT_EQ(after({v_mps, 0.0}, {factor * v_mps, 0.0}, 2.0), GuardReason::OdometryContradiction)
                << v_mps << " m/s by the wheels, times " << factor << " by the flow";
        }
        EXPECT_EQ(after({v_mps, 0.0}, {1.15 * v_mps, 0.0}, 2.0), GuardReason::None);
        EXPECT_EQ(after({v_mps, 0.0}, {0.85 * v_mps, 0.0}, 2.0), GuardReason::None);
    }
}

TEST(OdometryWatch, ForwardByTheFlowAndBackwardByTheWheelsIsAContradiction) {
    EXPECT_EQ(after({-0.1, 0.0}, {0.1, 0.0}, 2.0), GuardReason::OdometryContradiction);
    EXPECT_EQ(after({0.1, 0.0}, {-0.1, 0.0}, 2.0), GuardReason::OdometryContradiction);
}

TEST(OdometryWatch, ASpeedThatWasNotMeasuredContradictsNothing) {
    Drive drive = both({0.4, 0.0});
    drive.measures_v = false;
    drive.flow.v_mps = 0.0;
    EXPECT_FALSE(drive.go(5.0));
}

TEST(OdometryWatch, AContradictionIsForgottenAfterTheWindow) {
    Drive drive = both({0.3, 0.0});
    drive.go(1.0);
    drive.change({0.3, 0.0}, {0.3, 0.4});
    EXPECT_TRUE(drive.go(0.8));
    drive.change({0.3, 0.0}, {0.3, 0.0});
    EXPECT_TRUE(drive.go(0.4));
    EXPECT_FALSE(drive.go(1.6));
}

TEST(OdometryWatch, TheSameImageAgainAndAgainWhileTheWheelsMoveIsFrozen) {
    for (const MotionCommand& motion : {MotionCommand{0.2, 0.0}, MotionCommand{-0.1, 0.0},
                                        MotionCommand{0.0, 0.5}, MotionCommand{0.0, -0.5}}) {
        Drive drive = both(motion);
        drive.go(1.0);
        drive.repeats = true;
        EXPECT_FALSE(drive.go(2 * field_s));
        const double outline_m =
            (std::abs(motion.v_mps) + std::abs(motion.omega_radps) * circumscribed_m) * 3 * field_s;
        ASSERT_GT(outline_m, 0.01);
        EXPECT_EQ(drive.go(field_s).reason, GuardReason::SensorFrozen);
        drive.repeats = false;
        EXPECT_NE(drive.go(field_s).reason, GuardReason::SensorFrozen) << "a new image ends it";
    }
}

TEST(OdometryWatch, TheSameImageIsNotFrozenBeforeTheOutlineHasMoved) {
    Drive drive = both({0.03, 0.0});  // 1.2 mm a field
    drive.go(1.0);
    drive.repeats = true;
    EXPECT_FALSE(drive.go(8 * field_s));
    EXPECT_EQ(drive.go(field_s).reason, GuardReason::SensorFrozen);
}

TEST(OdometryWatch, TheSameImageOfAStandingOrCreepingRobotIsNotFrozen) {
    for (const double v_mps : {0.0, 0.02}) {  // 0.8 mm a field
        Drive drive = both({v_mps, 0.0});
        drive.repeats = true;
        EXPECT_FALSE(drive.go(3.0));
    }
}

TEST(OdometryWatch, BetweenAndAfterOdometriesTheWheelsAreTakenToMoveOn) {
    Drive drive = both({0.3, 0.3});
    drive.odometry_every = 5;  // 10 Hz
    EXPECT_FALSE(drive.go(2.0));
    drive.repeats = true;
    for (int field = 3; field < 12; ++field) {
        const Fault fault = drive.go(field == 3 ? 3 * field_s : field_s);
        EXPECT_EQ(fault.reason, GuardReason::SensorFrozen) << "every field shows motion, " << field;
    }
}

TEST(OdometryWatch, ConfirmsTheFlowOnceBothToldTheSameMotionSince) {
    for (const MotionCommand& motion : {MotionCommand{0.3, 0.0}, MotionCommand{-0.15, 0.0},
                                        MotionCommand{0.0, 0.4}, MotionCommand{0.0, -0.4}}) {
        Drive drive = both(motion);
        drive.go(1.0);
        EXPECT_TRUE(drive.watch.is_confirmed_since(0.2));
        EXPECT_FALSE(drive.watch.is_confirmed_since(drive.time_s - 2 * field_s)) << "too little since then";
        drive.go(1.0);
        EXPECT_TRUE(drive.watch.is_confirmed_since(1.0));
    }
}

TEST(OdometryWatch, DoesNotConfirmWhatStandsOrWhatDiffers) {
    Drive standing = both({0.0, 0.0});
    standing.go(2.0);
    EXPECT_FALSE(standing.watch.is_confirmed_since(0.0));
    for (const double factor : {0.6, 1.4, -1.0}) {
        Drive differing = both({0.3, 0.0});
        differing.flow.v_mps *= factor;
        differing.go(2.0);
        EXPECT_FALSE(differing.watch.is_confirmed_since(0.0)) << factor;
        Drive turning = both({0.0, 0.4});
        turning.flow.omega_radps *= factor;
        turning.go(2.0);
        EXPECT_FALSE(turning.watch.is_confirmed_since(0.0)) << factor;
    }
}

TEST(OdometryWatch, AfterATimeStampFarInTheFutureSilenceIsStillNoticed) {
    Drive drive = both({0.0, 0.0});
    drive.go(1.0);
    drive.watch.odometry(drive.time_s + 1000.0, drive.pose());
    drive.with_odometry = false;
    EXPECT_EQ(drive.go(2.0).reason, GuardReason::OdometryContradiction);
}

}  // namespace
}  // namespace flownav::nav
