#include "flownav/core/contact_floor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "flownav/testing/contact_scans.h"

namespace flownav {
namespace {

using Eigen::Vector2d;
using testing::block;
using testing::block_at;
using testing::confirm;
using testing::free_scan;
using testing::open_scan;

/// Index of the strip of a tangent.
int strip(const ContactScan& scan, double tangent) {
    return static_cast<int>(std::floor(tangent / scan.step)) - scan.first;
}

TEST(ContactFloor, IsConfirmedFromTheLowerBorderOfTheViewUpToTheEndOfTheStrip) {
    const ContactScan scan = free_scan(2.0);
    EXPECT_EQ(floor_at(scan, 0.39, 0.0, 0.0, 0.0), FloorSight::NotSeen) << "below the view";
    EXPECT_EQ(floor_at(scan, 0.41, 0.0, 0.0, 0.0), FloorSight::Confirmed);
    EXPECT_EQ(floor_at(scan, 1.99, 0.0, 0.0, 0.0), FloorSight::Confirmed);
    EXPECT_EQ(floor_at(scan, 2.01, 0.0, 0.0, 0.0), FloorSight::NotSeen);
    EXPECT_EQ(floor_at(scan, -1.0, 0.0, 0.0, 0.0), FloorSight::NotSeen) << "behind the camera";
}

TEST(ContactFloor, APlaceIsConfirmedWhenItIsFloorUpToItsFarEnd) {
    const ContactScan scan = free_scan(2.0);
    EXPECT_EQ(floor_at(scan, 1.94, 0.0, 0.05, 0.0), FloorSight::Confirmed);
    EXPECT_EQ(floor_at(scan, 1.96, 0.0, 0.05, 0.0), FloorSight::NotSeen);
    EXPECT_EQ(floor_at(scan, 1.96, 0.0, 0.05, 3.0), FloorSight::Unconfirmed);
}

TEST(ContactFloor, ToTheRightLieTheStripsOfPositiveTangent) {
    ContactScan scan = open_scan();
    confirm(scan, 0.2, 0.6, 2.0);
    EXPECT_EQ(floor_at(scan, 1.0, 0.4, 0.0, 0.0), FloorSight::Confirmed);
    EXPECT_EQ(floor_at(scan, 1.0, -0.4, 0.0, 0.0), FloorSight::NotSeen);
    EXPECT_EQ(floor_at(scan, 1.0, 1.4, 0.0, 0.0), FloorSight::NotSeen) << "outside the view";
}

TEST(ContactFloor, WhatIsInViewAndNotFreeIsUnconfirmedUpToTheGivenDistance) {
    const ContactScan scan = free_scan(0.8);
    EXPECT_EQ(floor_at(scan, 0.9, 0.0, 0.0, 1.2), FloorSight::Unconfirmed);
    EXPECT_EQ(floor_at(scan, 1.3, 0.0, 0.0, 1.2), FloorSight::NotSeen);
    ContactScan blind = open_scan();
    for (ContactStrip& s : blind.strips) s.seen = false;
    EXPECT_EQ(floor_at(blind, 0.9, 0.0, 0.0, 1.2), FloorSight::NotSeen);
}

TEST(ContactFloor, EndsAtTheNearEndOfAnObstacleAndOfThoseBesideIt) {
    ContactScan scan = free_scan(3.0);
    block(scan, 0.1, 0.15, 1.5);
    for (const double tangent : {0.075, 0.125, 0.175})
        EXPECT_NEAR(floor_to_m(scan, strip(scan, tangent)), 1.5, 1e-9) << tangent;
    for (const double tangent : {0.025, 0.225})
        EXPECT_NEAR(floor_to_m(scan, strip(scan, tangent)), 3.0, 1e-9) << tangent;
    EXPECT_EQ(floor_at(scan, 1.8, 0.125 * 1.8, 0.0, 9.0), FloorSight::NotSeen) << "hidden, not unconfirmed";
}

TEST(ContactFloor, AnUnknownStripHasNoneEvenWhenItHoldsADistance) {
    ContactScan scan = free_scan(3.0);
    scan.strips[20].kind = BeamKind::Unknown;
    EXPECT_EQ(floor_to_m(scan, 20), 0.0);
}

TEST(ContactFloor, TheShareOfFloorLeavesObstaclesOut) {
    ContactScan scan = open_scan();
    EXPECT_EQ(floor_share(scan), 0.0);
    confirm(scan, -1.0, 0.0, 2.0);
    EXPECT_NEAR(floor_share(scan), 0.5, 1e-9);
    block(scan, 0.0, 1.0, 1.0);
    EXPECT_NEAR(floor_share(scan), 1.0, 1e-9);
    EXPECT_EQ(floor_share(ContactScan{}), 0.0);
}

TEST(ContactFloor, ItsCellsAreThoseThatTheRobotSawAtTheEndOfTheCycle) {
    ContactScan scan = open_scan();
    confirm(scan, 0.2, 0.3, 2.0);
    scan.camera_m = {0.1, -0.05};
    scan.T_robot_scan = {-0.3, 0.1, 0.2};
    const Pose2 T_map_robot{2.0, -1.0, 1.1};
    const GridFrame frame{Vector2d(0.03, 0.01), 0.05};
    std::set<std::pair<int, int>> cells;
    for_each_floor_cell(scan, T_map_robot, frame, 0.0,
                        [&](const Eigen::Vector2i& cell, FloorSight sight, double forward_m) {
                            EXPECT_EQ(sight, FloorSight::Confirmed);
                            EXPECT_GT(forward_m, 0.4);
                            EXPECT_LT(forward_m, 2.0);
                            EXPECT_TRUE(cells.insert({cell.x(), cell.y()}).second);
                        });
    for (const double forward_m : {0.5, 1.0, 1.9}) {
        const Vector2d p = transform(T_map_robot, point_of(scan, 0.25, forward_m));
        EXPECT_EQ(cells.count({frame.cell_of(p).x(), frame.cell_of(p).y()}), 1U) << forward_m;
        const Vector2d other = transform(T_map_robot, point_of(scan, -0.25, forward_m));
        EXPECT_EQ(cells.count({frame.cell_of(other).x(), frame.cell_of(other).y()}), 0U) << forward_m;
    }
    const double area_m2 = 0.5 * 0.1 * (2.0 * 2.0 - 0.4 * 0.4);
    EXPECT_NEAR(static_cast<double>(cells.size()) * 0.05 * 0.05, area_m2, 0.15 * area_m2);
}

TEST(ContactFloor, AScanWithoutStripsHasNoCells) {
    const auto visit = [](const Eigen::Vector2i&, FloorSight, double) { FAIL(); };
    for_each_floor_cell(ContactScan{}, Pose2{}, GridFrame{}, 5.0, visit);
    ContactScan blind = open_scan();
    for (ContactStrip& s : blind.strips) s.seen = false;
    for_each_floor_cell(blind, Pose2{}, GridFrame{}, 5.0, visit);
}

TEST(ContactLine, IsAsWideAsItsStripAndRunsFromLeftToRight) {
    ContactScan scan = open_scan();
    block_at(scan, 0.2, 0.25, 2.0);
    const ContactLine line = line_of(scan, strip(scan, 0.225));
    EXPECT_LT((line.left_m - Vector2d(2.0, -0.4)).norm(), 1e-9) << "right of the robot y is negative";
    EXPECT_LT((line.middle_m - Vector2d(2.0, -0.45)).norm(), 1e-9);
    EXPECT_LT((line.right_m - Vector2d(2.0, -0.5)).norm(), 1e-9);
}

TEST(ContactLine, OfAWallJoinsThatOfItsNeighbourAtASimilarRange) {
    for (const BeamCause cause : {BeamCause::Wall, BeamCause::Drop}) {
        ContactScan scan = open_scan();
        const auto put = cause == BeamCause::Drop ? block : block_at;
        put(scan, 0.0, 0.05, 2.0, cause);
        put(scan, 0.05, 0.1, 2.4, cause);
        const ContactLine here = line_of(scan, 20);
        const ContactLine next = line_of(scan, 21);
        EXPECT_LT((here.right_m - next.left_m).norm(), 1e-9);
        EXPECT_NEAR(here.right_m.x(), 2.2, 1e-9);
    }
}

TEST(ContactLine, OfAWallDoesNotJoinAnotherAtAnotherRangeNorAPost) {
    ContactScan scan = open_scan();
    block_at(scan, 0.0, 0.05, 2.0, BeamCause::Wall);
    block_at(scan, 0.05, 0.1, 3.0, BeamCause::Wall);
    EXPECT_NEAR(line_of(scan, 20).right_m.x(), 2.0, 1e-9);
    block_at(scan, 0.05, 0.1, 2.2, BeamCause::Votes);
    EXPECT_NEAR(line_of(scan, 20).right_m.x(), 2.0, 1e-9);
    EXPECT_NEAR(line_of(scan, 21).left_m.x(), 2.2, 1e-9);
}

}  // namespace
}  // namespace flownav
