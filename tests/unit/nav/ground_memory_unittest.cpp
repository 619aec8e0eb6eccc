#include "flownav/nav/ground_memory.h"

#include <gtest/gtest.h>

#include "flownav/testing/contact_scans.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

const Pose2 here;

COccupancyGridMap2D silent_map() {
    COccupancyGridMap2D map(-3.0F, 3.0F, -3.0F, 3.0F, 0.1F);
    map.fill(0.5F);
    return map;
}

COccupancyGridMap2D map_with(const Vector2d& at_m, float p_free) {
    COccupancyGridMap2D map = silent_map();
    map.setPos(static_cast<float>(at_m.x()), static_cast<float>(at_m.y()), p_free);
    return map;
}

/// Remembered state of a place with an obstacle, after maps that no longer show it.
Ground after(const Vector2d& obstacle_m, double silent_s, const Pose2& T_map_robot = here) {
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(map_with(obstacle_m, 0.1F), 0.0, here);
    for (int i = 1; i * 0.25 <= silent_s; ++i) memory.note(silent_map(), i * 0.25, T_map_robot);
    return memory.at(obstacle_m, silent_s);
}

TEST(GroundMemory, WhatWentAwayBeforeTheCameraIsSoonForgotten) {
    EXPECT_EQ(after({1.05, 0.05}, 9.0), Ground::Occupied);
    EXPECT_EQ(after({1.05, 0.05}, 11.0), Ground::Unknown);
}

TEST(GroundMemory, WhatStandsBesideOrBehindTheRobotIsRememberedAMinute) {
    for (const Vector2d& at_m : {Vector2d(0.25, 0.35), Vector2d(0.25, -0.35), Vector2d(-0.45, 0.05)}) {
        EXPECT_EQ(after(at_m, 55.0), Ground::Occupied) << at_m.transpose();
        EXPECT_EQ(after(at_m, 65.0), Ground::Unknown) << at_m.transpose();
    }
}

TEST(GroundMemory, WhereTheCameraLooksIsToldFromTheRobotsHeading) {
    const Pose2 turned_left{0.0, 0.0, M_PI_2};
    EXPECT_EQ(after({0.05, 1.05}, 11.0, turned_left), Ground::Unknown);
    EXPECT_EQ(after({1.05, 0.05}, 11.0, turned_left), Ground::Occupied);
}

TEST(GroundMemory, GroundThatIsSeenFreeIsNoObstacleAnyMore) {
    GroundMemory memory{GroundMemoryParams{}};
    const Vector2d beside_m(0.25, 0.35);
    memory.note(map_with(beside_m, 0.1F), 0.0, here);
    EXPECT_EQ(memory.note(map_with(beside_m, 0.9F), 1.0, here), 0) << "it was not unknown";
    EXPECT_EQ(memory.at(beside_m, 1.0), Ground::Free);
}

TEST(GroundMemory, TheLimitsOfTheGuardDecideWhatIsAnObstacleAndWhatIsFree) {
    const auto ground_of = [](float p_free, double obstacle_below, double free_above) {
        GroundMemoryParams params;
        params.limits.guard_obstacle_below = obstacle_below;
        params.limits.guard_free_above = free_above;
        GroundMemory memory(params);
        memory.note(map_with({1.05, 0.05}, p_free), 0.0, here);
        return memory.at(Vector2d(1.05, 0.05), 0.0);
    };
    EXPECT_EQ(ground_of(0.38F, 0.4, 0.55), Ground::Occupied);
    EXPECT_EQ(ground_of(0.38F, 0.35, 0.55), Ground::Unknown);
    EXPECT_EQ(ground_of(0.6F, 0.4, 0.55), Ground::Free);
    EXPECT_EQ(ground_of(0.6F, 0.4, 0.65), Ground::Unknown);
}

TEST(GroundMemory, WhereTheRobotStandsNothingElseDoes) {
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(map_with({0.05, 0.05}, 0.1F), 0.0, here);
    memory.mark_traversed({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}}, 1.0, here);
    EXPECT_EQ(memory.at(Vector2d(0.05, 0.05), 1.0), Ground::Driven);
}

/// A map whose first column and row are occupied has no data for the strip of cells outside it.
TEST(GroundMemory, BesideTheMapNothingIsKnown) {
    COccupancyGridMap2D map = silent_map();
    for (unsigned i = 0; i < map.getSizeX(); ++i) {
        const int last = static_cast<int>(map.getSizeX()) - 1;
        for (const int border : {0, last}) {
            map.setCell(border, static_cast<int>(i), 0.1F);
            map.setCell(static_cast<int>(i), border, 0.1F);
        }
    }
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(map, 0.0, here);
    for (const double side : {-1.0, 1.0}) {
        EXPECT_EQ(memory.at(Vector2d(side * 2.98, 0.52), 0.0), Ground::Occupied) << side;
        EXPECT_EQ(memory.at(Vector2d(0.52, side * 2.98), 0.0), Ground::Occupied) << side;
        EXPECT_EQ(memory.at(Vector2d(side * 3.03, 0.52), 0.0), Ground::Unknown) << side;
        EXPECT_EQ(memory.at(Vector2d(0.52, side * 3.03), 0.0), Ground::Unknown) << side;
    }
}

/// Remembered state of a place after `scans` equal scans, a second apart.
Ground after_scans(const ContactScan& scan, int scans, const Vector2d& at_m,
                   const GroundMemoryParams& params = {}) {
    GroundMemory memory(params);
    for (int i = 0; i < scans; ++i) memory.note(scan, i, here);
    return memory.at(at_m, scans);
}

/// Floor up to 2 m to the left of the heading and straight ahead, none to the right, where it was looked for.
ContactScan floor_to_the_left() {
    ContactScan scan = testing::open_scan();
    testing::confirm(scan, -1.0, 0.6, 2.0);
    return scan;
}

TEST(GroundMemory, GroundInViewThatSeveralScansDoNotConfirmIsUnconfirmed) {
    const Vector2d right_m(1.0, -0.8);
    EXPECT_EQ(after_scans(floor_to_the_left(), 2, right_m), Ground::Unknown);
    EXPECT_EQ(after_scans(floor_to_the_left(), 3, right_m), Ground::Unconfirmed);
    for (const Vector2d& at_m : {Vector2d(1.0, 0.8), {1.0, 0.0}, {0.3, -0.25}, {1.3, -1.1}, {1.0, -1.2}})
        EXPECT_EQ(after_scans(floor_to_the_left(), 50, at_m), Ground::Unknown) << at_m.transpose();
}

TEST(GroundMemory, UnconfirmedGroundLiesWhereTheRobotSawItFrom) {
    GroundMemory memory{GroundMemoryParams{}};
    const Pose2 turned_left{2.0, 1.0, M_PI_2};
    ContactScan scan = floor_to_the_left();
    scan.T_robot_scan = {-0.2, 0.0, 0.0};
    for (int i = 0; i < 5; ++i) memory.note(scan, i, turned_left);
    EXPECT_EQ(memory.at(transform(turned_left, {0.8, -0.8}), 5.0), Ground::Unconfirmed);
    EXPECT_EQ(memory.at(transform(turned_left, {0.8, 0.8}), 5.0), Ground::Unknown);
}

TEST(GroundMemory, OnFloorWithLittleTextureAScanThatMissesItSaysLittle) {
    const Vector2d ahead_m(1.0, 0.02);
    EXPECT_EQ(after_scans(testing::open_scan(), 100, ahead_m), Ground::Unknown) << "no texture at all";
    ContactScan half = testing::open_scan();
    for (std::size_t i = 0; i < half.strips.size(); i += 2) {
        half.strips[i].kind = BeamKind::Free;
        half.strips[i].free_m = 0.9;
    }
    EXPECT_EQ(after_scans(half, 5, ahead_m), Ground::Unknown);
    EXPECT_EQ(after_scans(half, 6, ahead_m), Ground::Unconfirmed);
}

TEST(GroundMemory, WhatWasSeenFreeOrDrivenOverIsNotUnconfirmed) {
    const ContactScan scan = testing::free_scan(0.7);
    const Vector2d ahead_m(0.95, 0.05);
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(map_with(ahead_m, 0.9F), 0.0, here);
    for (int i = 0; i < 9; ++i) memory.note(scan, i, here);
    EXPECT_EQ(memory.at(ahead_m, 9.0), Ground::Free);
    memory.mark_traversed({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}}, 9.0, {0.95, 0.5, 0.0});
    for (int i = 10; i < 20; ++i) memory.note(scan, i, here);
    EXPECT_EQ(memory.at(Vector2d(0.95, 0.4), 20.0), Ground::Driven);
    EXPECT_EQ(memory.at(Vector2d(0.95, -0.4), 20.0), Ground::Unconfirmed);
}

TEST(GroundMemory, UnconfirmedGroundEndsWithTimeWithFloorAndUnderTheRobot) {
    const Vector2d ahead_m(0.95, 0.05);
    GroundMemory memory{GroundMemoryParams{}};
    const auto look = [&](double free_m, double from_s) {
        for (int i = 0; i < 3; ++i) memory.note(testing::free_scan(free_m), from_s + i, here);
    };
    look(0.7, 0.0);
    EXPECT_EQ(memory.at(ahead_m, 60.0), Ground::Unconfirmed);
    EXPECT_EQ(memory.at(ahead_m, 63.0), Ground::Unknown);
    look(0.7, 100.0);
    look(2.0, 103.0);
    EXPECT_EQ(memory.at(ahead_m, 106.0), Ground::Unknown);
    look(0.7, 140.0);
    EXPECT_GT(memory.note(map_with(ahead_m, 0.9F), 143.0, here), 0) << "it counts as new ground";
    EXPECT_EQ(memory.at(ahead_m, 143.0), Ground::Free);
}

TEST(GroundMemory, WhatAnEarlierMapShowedFreeBecomesUnconfirmedOnceTheMapDoubtsIt) {
    const Vector2d ahead_m(0.95, 0.05);
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(map_with(ahead_m, 0.9F), 0.0, here);
    for (int i = 1; i < 5; ++i) {
        memory.note(map_with(ahead_m, 0.5F), i, here);
        memory.note(testing::free_scan(0.7), i, here);
    }
    EXPECT_EQ(memory.at(ahead_m, 5.0), Ground::Unconfirmed);
}

TEST(GroundMemory, AnObstacleTooNearForTheCameraKeepsItsMemory) {
    const auto after_12_s = [](const Vector2d& at_m) {
        GroundMemory memory{GroundMemoryParams{}};
        ContactScan scan = testing::open_scan();
        scan.view_near_m = 0.7;
        memory.note(map_with(at_m, 0.1F), 0.0, here);
        memory.note(scan, 0.5, here);
        memory.note(map_with(at_m, 0.5F), 1.0, here);
        return memory.at(at_m, 12.5);
    };
    EXPECT_EQ(after_12_s({0.55, 0.05}), Ground::Occupied);
    EXPECT_EQ(after_12_s({2.25, 0.05}), Ground::Unknown);
}

TEST(GroundMemory, ADistanceOfZeroSwitchesUnconfirmedGroundOff) {
    GroundMemoryParams params;
    params.unconfirmed_within_m = 0.0;
    EXPECT_EQ(after_scans(testing::free_scan(0.7), 9, {0.95, 0.05}, params), Ground::Unknown);
}

TEST(GroundMemory, WhatAScanConfirmsStaysConfirmedAsLongAsFreeGround) {
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(floor_to_the_left(), 0.0, here);
    EXPECT_TRUE(memory.is_confirmed({1.0, 0.5}, 29.0));
    EXPECT_FALSE(memory.is_confirmed({1.0, 0.5}, 31.0));
    EXPECT_FALSE(memory.is_confirmed({1.0, -0.8}, 1.0));
    EXPECT_FALSE(memory.is_confirmed({2.3, 0.5}, 1.0));
    memory.mark_traversed({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}}, 1.0, {1.0, -0.8, 0.0});
    EXPECT_TRUE(memory.is_confirmed({1.0, -0.8}, 100.0)) << "it was driven over";
}

TEST(GroundMemory, AScanThatSeesTheFloorEndEarlierTakesAConfirmationBack) {
    GroundMemory memory{GroundMemoryParams{}};
    const auto is_confirmed_after = [&](double free_m) {
        memory.note(testing::free_scan(free_m), 1.0, here);
        return memory.is_confirmed({1.2, 0.05}, 1.0);
    };
    EXPECT_TRUE(is_confirmed_after(1.5));
    EXPECT_FALSE(is_confirmed_after(1.0));
    for (int i = 0; i < 9; ++i) EXPECT_TRUE(is_confirmed_after(1.5));
    EXPECT_TRUE(is_confirmed_after(1.0)) << "one of many may miss the floor";
    EXPECT_FALSE(is_confirmed_after(1.0));
}

TEST(GroundMemory, AnUnconfirmedCellBetweenTwoFreeOnesIsPassedAndOneBesideThemIsNot) {
    GroundMemory memory{GroundMemoryParams{}};
    for (int i = 0; i < 3; ++i) memory.note(testing::free_scan(0.7), i, here);
    COccupancyGridMap2D map(-3.0F, 3.0F, -3.0F, 3.0F, 0.05F);
    map.fill(0.5F);
    for (const float y_m : {0.025F, 0.125F}) map.setPos(0.975F, y_m, 0.9F);
    memory.note(map, 3.0, here);
    EXPECT_FALSE(memory.is_unconfirmed({0.975, 0.075}, 3.0));
    for (const Vector2d& at_m : {Vector2d(0.975, 0.175), {0.975, -0.025}, {1.025, 0.025}})
        EXPECT_TRUE(memory.is_unconfirmed(at_m, 3.0)) << at_m.transpose();
}

TEST(GroundMemory, GroundThatTwoScansLookedAtIsScannedUntilAnObstacleIsSeenThere) {
    GroundMemory memory{GroundMemoryParams{}};
    const Vector2d ahead_m(0.85, 0.05);
    const Vector2d behind_m(-0.85, 0.05);
    for (int i = 0; i < 2; ++i) {
        EXPECT_FALSE(memory.is_scanned(ahead_m, i));
        memory.note(testing::open_scan(), i, here);
    }
    EXPECT_TRUE(memory.is_scanned(ahead_m, 1.0));
    EXPECT_FALSE(memory.is_scanned(behind_m, 1.0));
    memory.note(map_with(ahead_m, 0.1F), 1.0, here);
    EXPECT_FALSE(memory.is_scanned(ahead_m, 1.0));
}

TEST(GroundMemory, AnObstacleThatTheMapNoLongerShowsIsForgottenAfterThreeScansThatSeeNothing) {
    for (const double right : {-0.25, 0.25}) {
        GroundMemory memory{GroundMemoryParams{}};
        const Vector2d at_m(1.45, -right * 1.45);
        const Vector2d mirrored_m(1.45, right * 1.45);
        memory.note(map_with(at_m, 0.1F), 0.0, here);
        COccupancyGridMap2D both = map_with(at_m, 0.1F);
        both.setPos(1.45F, static_cast<float>(mirrored_m.y()), 0.1F);
        memory.note(both, 0.0, here);
        ContactScan scan = testing::open_scan();
        testing::block(scan, -right - 0.1, -right + 0.1, 1.35);  // hides the mirrored one
        for (int i = 1; i <= 3; ++i) {
            EXPECT_EQ(memory.at(at_m, 0.1 * i), Ground::Occupied) << i;
            memory.note(scan, 0.1 * i, here);
        }
        EXPECT_EQ(memory.at(at_m, 0.4), Ground::Unknown);
        EXPECT_EQ(memory.at(mirrored_m, 0.4), Ground::Occupied);
    }
}

TEST(GroundMemory, AnObstacleThatTheMapShowsIsNotForgottenForScansThatMissIt) {
    GroundMemory memory{GroundMemoryParams{}};
    const Vector2d at_m(1.45, 0.05);
    for (int i = 0; i < 10; ++i) {
        memory.note(map_with(at_m, 0.1F), 0.1 * i, here);
        memory.note(testing::open_scan(), 0.1 * i, here);
    }
    EXPECT_EQ(memory.at(at_m, 1.0), Ground::Occupied);
}

}  // namespace
}  // namespace flownav::nav
