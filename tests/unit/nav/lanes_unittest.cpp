#include "flownav/nav/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "course.h"
#include "flownav/nav/motion_model.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

const LaneTables& tables() {
    static const LaneTables made = [] {
        LaneLayout layout;
        layout.resolution_m = 0.05;
        return make_lane_tables(RobotModel(), layout);
    }();
    return made;
}

LaneDecision choose(const Course& course, const Vector2d& waypoint_m, const MotionCommand& motion = {}) {
    return choose_lane(tables(), course.local_map({}), waypoint_m, motion, LaneParams());
}

TEST(Lanes, OverFreeGroundTheRobotDrivesStraightAtFullSpeed) {
    const LaneDecision decision = choose({}, {4.0, 0.0}, {0.4, 0.0});
    EXPECT_EQ(decision.command.v_mps, RobotModel().v_max_mps);
    EXPECT_EQ(decision.command.omega_radps, 0.0);
    EXPECT_FALSE(decision.stuck);
    EXPECT_EQ(decision.lanes.size(), tables().lanes.size());
}

TEST(Lanes, AWayPointToTheLeftTurnsLeftAndOneToTheRightTurnsRight) {
    EXPECT_GT(choose({}, {2.0, 0.7}).command.omega_radps, 0.0);
    EXPECT_LT(choose({}, {2.0, -0.7}).command.omega_radps, 0.0);
    EXPECT_GT(choose({}, {2.0, 0.7}).command.v_mps, 0.0);
}

TEST(Lanes, AnObstacleToTheLeftIsPassedOnTheRightAndTheOtherWayRound) {
    Course left;
    left.add(1.2, 0.12);
    EXPECT_LT(choose(left, {3.0, 0.0}).command.omega_radps, 0.0);
    Course right;
    right.add(1.2, -0.12);
    EXPECT_GT(choose(right, {3.0, 0.0}).command.omega_radps, 0.0);
}

TEST(Lanes, AWayPointBehindIsTurnedToOnTheSpotTheShortWay) {
    const LaneDecision left = choose({}, {-2.0, 0.5});
    EXPECT_EQ(left.command.v_mps, 0.0);
    EXPECT_GT(left.command.omega_radps, 0.0);
    const LaneDecision right = choose({}, {-2.0, -0.5});
    EXPECT_EQ(right.command.v_mps, 0.0);
    EXPECT_LT(right.command.omega_radps, 0.0);
}

TEST(Lanes, OnceTurningItTurnsUntilTheWayPointIsAhead) {
    EXPECT_GT(choose({}, {1.0, 1.5}, {0.3, 0.3}).command.v_mps, 0.0);
    EXPECT_EQ(choose({}, {1.0, 1.5}, {0.0, 0.8}).command.v_mps, 0.0);
    EXPECT_GT(choose({}, {2.0, 0.3}, {0.0, 0.8}).command.v_mps, 0.0);
}

TEST(Lanes, ItTurnsOnTheSpotOnlyWhereTheCornersFindRoom) {
    Course course;  // a post in the left turn, a little beyond the front left corner
    course.add(0.1, 0.33, 0.03);
    const LaneDecision decision = choose(course, {-2.0, 0.05});
    EXPECT_EQ(decision.command.v_mps, 0.0);
    EXPECT_LE(decision.command.omega_radps, 0.0);
}

TEST(Lanes, EnclosedItIsStuckAndStands) {
    Course course;
    course.add_wall({0.42, -0.4}, {0.42, 0.4});
    course.add_wall({-0.4, 0.38}, {0.4, 0.38});
    course.add_wall({-0.4, -0.38}, {0.4, -0.38});
    course.add_wall({-0.42, -0.4}, {-0.42, 0.4});
    const LaneDecision decision = choose(course, {3.0, 0.0});
    EXPECT_TRUE(decision.stuck);
    EXPECT_EQ(decision.command.v_mps, 0.0);
    EXPECT_EQ(decision.command.omega_radps, 0.0);
    EXPECT_EQ(decision.lane, -1);
}

TEST(Lanes, AWeakHitCostsButDoesNotBlock) {
    Course course;
    auto map = course.local_map({});
    for (double y = -0.3; y < 0.3; y += 0.02) map.setPos(1.0F, static_cast<float>(y), 0.36F);
    const LaneDecision across = choose_lane(tables(), map, {3.0, 0.0}, {}, LaneParams());
    const LaneView& straight = across.lanes[across.lanes.size() / 2];
    EXPECT_EQ(straight.free_m, tables().lanes[across.lanes.size() / 2].length_m);
    EXPECT_LT(straight.sure, 1.0);
    // Twice the evidence makes it an obstacle.
    for (double y = -0.3; y < 0.3; y += 0.02) map.setPos(1.0F, static_cast<float>(y), 0.24F);
    const LaneDecision before = choose_lane(tables(), map, {3.0, 0.0}, {}, LaneParams());
    EXPECT_LT(before.lanes[before.lanes.size() / 2].free_m, 0.8);
}

TEST(Lanes, UnseenGroundSlows) {
    Course course;
    course.p_elsewhere = 0.5F;
    const LaneDecision nothing_seen = choose(course, {4.0, 0.0}, {0.4, 0.0});
    EXPECT_NEAR(nothing_seen.command.v_mps, LaneParams().unseen_mps, 0.02);
    auto map = course.local_map({});
    for (double x = 0.26; x < 0.95; x += 0.05)
        for (double y = -3.0; y < 3.0; y += 0.05)
            map.setPos(static_cast<float>(x), static_cast<float>(y), 0.8F);
    const LaneDecision some_seen = choose_lane(tables(), map, {4.0, 0.0}, {0.4, 0.0}, LaneParams());
    EXPECT_GT(some_seen.command.v_mps, nothing_seen.command.v_mps);
    EXPECT_LT(some_seen.way.unseen, 0.8);
    EXPECT_EQ(choose({}, {4.0, 0.0}, {0.4, 0.0}).command.v_mps, 0.4);
}

TEST(Lanes, SeenGroundIsPreferred) {
    for (const double side : {1.0, -1.0}) {
        Course course;
        course.add(1.5, 0.0);  // right ahead: left and right are equivalent
        auto map = course.local_map({});
        for (double x = 0.8; x < 4.0; x += 0.05)  // one side is unseen
            for (double y = 0.1; y < 3.0; y += 0.05)
                map.setPos(static_cast<float>(x), static_cast<float>(side * y), 0.5F);
        EXPECT_LT(choose_lane(tables(), map, {3.0, 0.0}, {}, LaneParams()).command.omega_radps * side, 0.0);
    }
}

TEST(Lanes, NarrowPlacesAreDrivenSlowly) {
    Course wide;
    Course narrow;
    for (const double side : {1.0, -1.0}) {
        wide.add_wall({-1.0, side * 1.2}, {3.0, side * 1.2});
        narrow.add_wall({-1.0, side * 0.42}, {3.0, side * 0.42});
    }
    EXPECT_EQ(choose(wide, {4.0, 0.0}).command.v_mps, 0.4);
    EXPECT_LT(choose(narrow, {4.0, 0.0}).command.v_mps, 0.35);
    EXPECT_GT(choose(narrow, {4.0, 0.0}).command.v_mps, 0.1);
}

TEST(Lanes, ItSlowsDownTowardTheWayPoint) {
    EXPECT_LT(choose({}, {0.05, 0.0}, {0.3, 0.0}).command.v_mps, 0.3);
    EXPECT_GE(choose({}, {0.05, 0.0}, {0.3, 0.0}).command.v_mps, 0.1);
}

/// Random posts, some of them near.
Course random_course(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto between = [&random](double low, double high) {
        return low + (high - low) * (static_cast<double>(random() >> 11U) * 0x1p-53);
    };
    Course course;
    for (int i = 0; i < 25; ++i) {
        const double x = between(-2.0, 3.5);
        const double y = between(-2.0, 2.0);
        const double radius = between(0.03, 0.15);
        if (signed_distance_m(RobotModel().footprint_m, {x, y}) > radius + 0.1) course.add(x, y, radius);
    }
    return course;
}

TEST(Lanes, ABlockedLaneIsNeverChosen) {
    int driven = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        const Course course = random_course(seed);
        const MotionCommand motion{0.1 * static_cast<double>(seed % 5), 0.0};
        const LaneDecision decision = choose(course, {3.0, 0.02 * static_cast<double>(seed) - 1.5}, motion);
        ASSERT_LE(std::abs(decision.command.omega_radps), RobotModel().omega_max_radps + 1e-9);
        ASSERT_LE(decision.command.v_mps, RobotModel().v_max_mps);
        if (decision.lane < 0) continue;
        ++driven;
        const double braking_m = stopping_distance_m(RobotModel(), decision.command.v_mps);
        ASSERT_GE(decision.way.occupied, braking_m);
        const double kappa = decision.lanes[static_cast<std::size_t>(decision.lane)].curvature_1pm;
        for (double way_m = 0.0; way_m < decision.way.occupied - 0.03; way_m += 0.01) {
            const Pose2 there = inverse(pose_after({1.0, kappa}, way_m));
            for (const Course::Post& post : course.posts)
                ASSERT_GT(signed_distance_m(RobotModel().footprint_m, transform(there, post.at_m)),
                          post.radius_m - 0.001)
                    << "seed " << seed << " after " << way_m << " m";
        }
    }
    EXPECT_GT(driven, 100);
}

TEST(Lanes, TheSameQuestionHasTheSameAnswer) {
    const Course course = random_course(7);
    const LaneDecision first = choose(course, {3.0, 0.4}, {0.3, 0.1});
    const LaneDecision second = choose(course, {3.0, 0.4}, {0.3, 0.1});
    EXPECT_EQ(first.command.v_mps, second.command.v_mps);
    EXPECT_EQ(first.command.omega_radps, second.command.omega_radps);
    EXPECT_EQ(first.lane, second.lane);
}

TEST(Lanes, ThePresentTurnIsKeptWhenItIsAsGood) {
    Course course;
    course.add(1.5, 0.0);  // right ahead: left and right are equivalent
    EXPECT_GT(choose(course, {3.0, 0.0}, {0.4, 0.2}).command.omega_radps, 0.0);
    EXPECT_LT(choose(course, {3.0, 0.0}, {0.4, -0.2}).command.omega_radps, 0.0);
}

TEST(Lanes, AMapThatDoesNotFitIsRefused) {
    Course course;
    course.cell_m = 0.1;
    EXPECT_THROW(choose(course, {1.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace flownav::nav
