#include <gtest/gtest.h>

#include <cmath>

#include "flownav/mapping/export.h"
#include "flownav/mapping/local_map.h"
#include "flownav/math/units.h"
#include "flownav/testing/contact_scans.h"
#include "obstacle_sets.h"

namespace flownav::mapping {
namespace {

using Eigen::Vector2d;
using testing::block_at;
using testing::confirm;
using testing::free_scan;
using testing::occupancy;
using testing::occupied_cells;
using testing::open_scan;

constexpr double unknown = 0.5;
constexpr double tolerance = 0.01;  // a cell is one byte

ObstacleSet set_of(const ContactScan& contacts, const Pose2& T_map_robot = {}, double timestamp_s = 0.0) {
    return {timestamp_s, T_map_robot, {}, {}, contacts};
}

/// Both maps, with the robot at the origin, after `sets` equal sets.
struct Maps {
    explicit Maps(const ObstacleSet& set, int sets = 2) {
        for (int i = 0; i < sets; ++i) insert(set);
    }
    void insert(const ObstacleSet& set) {
        local.insert(set);
        global.insert(set);
    }
    /// Probability that a place is occupied. Fails when the maps differ by more than their limits explain.
    double occupied(double x_m, double y_m) const {
        EXPECT_NEAR(occupancy(local.grid(), x_m, y_m), occupancy(global.grid(), x_m, y_m), 0.06);
        return occupancy(global.grid(), x_m, y_m);
    }

    LocalMap local{MapParams{}};
    GlobalMap global{MapParams{}};
};

/// A post 10 cm wide in tangent, 2.05 m ahead: right of the heading when `side` is 1.
ContactScan post(double side) {
    ContactScan scan = open_scan();
    block_at(scan, side * 0.25 - 0.05, side * 0.25 + 0.05, 2.05);
    return scan;
}

TEST(ContactsInMaps, APostToTheRightIsOccupiedToTheRightAfterTwoScans) {
    for (const double side : {1.0, -1.0}) {
        const Maps maps(set_of(post(side)));
        EXPECT_GT(maps.occupied(2.05, -0.55 * side), 0.7);
        EXPECT_GT(maps.occupied(2.05, -0.45 * side), 0.7);
        EXPECT_NEAR(maps.occupied(2.05, 0.55 * side), unknown, tolerance);
        EXPECT_NEAR(maps.occupied(2.35, -0.55 * side), unknown, tolerance) << "it is not so deep";
        EXPECT_LE(occupied_cells(maps.global.grid()), 7);
    }
}

TEST(ContactsInMaps, AThingIsTakenToBeTenCentimetresDeep) {
    for (const double side : {1.0, -1.0}) {
        const Maps maps(set_of(post(side)));
        EXPECT_GT(maps.occupied(2.125, -0.25 * 2.125 * side), 0.6);
        EXPECT_NEAR(maps.occupied(2.225, -0.25 * 2.225 * side), unknown, tolerance);
    }
}

TEST(ContactsInMaps, AContactThatScansSeeFartherAwayFadesWhereOneSawItNearer) {
    ContactScan nearer = open_scan();
    block_at(nearer, 0.2, 0.3, 1.875);
    Maps maps(set_of(nearer), 1);
    EXPECT_GT(maps.occupied(1.875, -0.25 * 1.875), 0.7);
    for (int i = 0; i < 10; ++i) maps.insert(set_of(post(1.0)));
    EXPECT_LE(maps.occupied(1.875, -0.25 * 1.875), unknown + tolerance);
    EXPECT_GT(maps.occupied(2.05, -0.25 * 2.05), 0.7);
}

TEST(ContactsInMaps, OneSightIsEnoughForTheGuardEvenWhereFloorWasSeenBefore) {
    Maps maps(set_of(free_scan(3.0)), 10);
    const auto here = [&] { return occupancy(maps.local.grid(), 2.05, -0.55); };
    EXPECT_LT(here(), 0.4);
    maps.local.insert(set_of(post(1.0)));
    EXPECT_GT(here(), 1.0 - OccupancyLimits().guard_obstacle_below);
}

TEST(ContactsInMaps, ScansThatSeeNothingMakeAnObstacleUnknownAndNotFree) {
    ContactScan seen = open_scan();
    block_at(seen, 0.2, 0.3, 1.55);
    Maps maps(set_of(seen), 1);
    const auto here = [&] { return maps.occupied(1.55, -0.25 * 1.55); };
    const double before = here();
    maps.insert(set_of(open_scan()));
    EXPECT_LT(here(), before - 0.02);
    for (int i = 0; i < 20; ++i) maps.insert(set_of(open_scan()));
    EXPECT_NEAR(here(), unknown, tolerance);
}

TEST(ContactsInMaps, WhereScansSeeTheFloorEndNearbyFreeGroundBecomesUnknownAndNotOccupied) {
    Maps maps(set_of(free_scan(3.0)), 3);
    for (int i = 0; i < 10; ++i) maps.insert(set_of(free_scan(0.8)));
    EXPECT_NEAR(maps.occupied(1.05, 0.05), unknown, tolerance);
    EXPECT_LT(maps.occupied(1.65, 0.05), 0.4) << "so far away a scan may miss the floor";
    EXPECT_LT(occupancy(maps.local.grid(), 0.65, 0.05), 0.4);
}

TEST(ContactsInMaps, DoubtsOutliveWhatTheyDoubtedAndMakeNothingOfIt) {
    LocalMap map{MapParams{}};
    const auto here = [&](double x_m, double y_m) { return occupancy(map.grid(), x_m, y_m); };
    ContactScan seen = open_scan();
    block_at(seen, 0.2, 0.3, 1.55);
    for (int i = 0; i < 3; ++i) map.insert(set_of(free_scan(3.0), {}, 0.1 * i));
    for (int i = 0; i < 3; ++i) map.insert(set_of(seen, {}, 0.3 + 0.1 * i));
    for (int i = 0; i < 30; ++i) map.insert(set_of(free_scan(0.8), {}, 1.0 + 0.1 * i));
    map.insert(set_of(open_scan(), {}, 0.6 + MapParams().memory_s));
    EXPECT_NEAR(here(1.05, 0.05), unknown, tolerance) << "floor that was doubted is no obstacle";
    EXPECT_NEAR(here(1.55, -0.25 * 1.55), unknown, tolerance) << "an obstacle that was doubted is no floor";
}

TEST(ContactsInMaps, AScanThatWouldNotSeeAnObstacleDoesNotDoubtIt) {
    for (const double near_m : {0.75, 2.25}) {
        ContactScan seen = open_scan();
        block_at(seen, 0.2, 0.3, near_m);
        Maps maps(set_of(seen), 1);
        const double before = maps.occupied(near_m, -0.25 * near_m);
        maps.insert(set_of(open_scan()));
        EXPECT_NEAR(maps.occupied(near_m, -0.25 * near_m), before, tolerance) << near_m;
    }
}

TEST(ContactsInMaps, AScanOfAnEarlierMomentLandsWhereItWasTaken) {
    ContactScan scan = post(1.0);
    scan.camera_m = {0.2, 0.0};
    const Pose2 T_map_scan{0.3, 0.2, 0.4};
    const Pose2 T_map_record{0.5, 0.3, 0.5};
    scan.T_robot_scan = compose(inverse(T_map_record), T_map_scan);
    Maps maps(set_of(scan, T_map_record));
    const Vector2d p = transform(T_map_scan, {2.25, -0.25 * 2.05});
    EXPECT_GT(occupancy(maps.global.grid(), p.x(), p.y()), 0.7);
    maps.local.redraw({});
    EXPECT_GT(occupancy(maps.local.grid(), p.x(), p.y()), 0.7);
}

TEST(ContactsInMaps, AWallIsClosedFromItsFirstStripToItsLast) {
    // A wall that recedes to the right: y = -0.5 - x / 2, seen at tangents from 0.7 to 0.95.
    ContactScan scan = open_scan();
    const auto forward_m = [](double tangent) { return 0.5 / (tangent - 0.5); };
    for (double tangent = 0.725; tangent < 0.95; tangent += 0.05)
        block_at(scan, tangent - 0.01, tangent + 0.01, forward_m(tangent), BeamCause::Wall);
    const Maps maps(set_of(scan));
    for (double tangent = 0.725; tangent < 0.925; tangent += 0.005) {
        const double x = forward_m(tangent);
        double most = 0.0;
        for (const double dx : {-0.1, 0.0, 0.1})
            for (const double dy : {-0.1, 0.0, 0.1})
                most = std::max(most, occupancy(maps.global.grid(), x + dx, -tangent * x + dy));
        EXPECT_GT(most, 0.7) << "x " << x;
    }
}

TEST(ContactsInMaps, FloorIsFreeUpToTheEndOfItsStripAndNoFarther) {
    ContactScan scan = open_scan();
    confirm(scan, 0.2, 0.4, 1.5);
    const Maps maps(set_of(scan), 4);
    for (double x = 0.55; x < 1.45; x += 0.1) {
        EXPECT_LT(maps.occupied(x, -0.3 * x), 0.35) << x;
        EXPECT_NEAR(maps.occupied(x, 0.3 * x), unknown, tolerance) << "the other side";
    }
    EXPECT_NEAR(maps.occupied(0.25, -0.08), unknown, tolerance) << "below the view";
    EXPECT_NEAR(maps.occupied(1.65, -0.5), unknown, tolerance);
}

TEST(ContactsInMaps, FloorEndsBeforeAPostAndInTheStripsBesideIt) {
    ContactScan scan = free_scan(3.0);
    block_at(scan, 0.0, 0.05, 1.55);
    const Maps maps(set_of(scan), 4);
    for (const double tangent : {-0.02, 0.02, 0.07}) {
        EXPECT_LT(maps.occupied(1.25, -1.25 * tangent), 0.35) << tangent;
        EXPECT_NEAR(maps.occupied(2.25, -2.25 * tangent), unknown, tolerance) << tangent;
    }
    EXPECT_GT(maps.occupied(1.55, -0.04), 0.7);
    EXPECT_LT(maps.occupied(2.25, 0.5), 0.35) << "farther aside it goes on";
}

TEST(ContactsInMaps, AnUnknownStripChangesNoCell) {
    Maps maps(set_of(open_scan()), 5);
    for (unsigned y = 0; y < maps.global.grid().getSizeY(); ++y)
        for (unsigned x = 0; x < maps.global.grid().getSizeX(); ++x)
            ASSERT_NEAR(maps.global.grid().getCell(static_cast<int>(x), static_cast<int>(y)), 0.5, tolerance);
}

/// The files of both maps after a short drive past a thing, with `contacts` in every set.
std::string files_after(const ContactScan& contacts) {
    LocalMap local{MapParams{}};
    GlobalMap global{MapParams{}};
    std::string bytes;
    for (int i = 0; i < 30; ++i) {
        ObstacleSet set = testing::set_seeing(2.25, 0.45, {0.05 * i, 0.01 * i, 0.02 * i}, 0.3 * i);
        set.ground.push_back({{0.6, 0.1}, {1.7, -0.2}, 0.3});
        set.points.push_back(testing::point_at(1.0, -0.5));
        set.points.back().moving = i % 3 == 0;
        set.contacts = contacts;
        local.insert(set);
        global.insert(set);
        const MapFiles files = export_map(local.grid());
        bytes.append(files.gridmap.begin(), files.gridmap.end());
    }
    const MapFiles files = export_map(global.grid());
    return bytes.append(files.gridmap.begin(), files.gridmap.end()) + files.pgm;
}

TEST(ContactsInMaps, WithoutAnOpenScanEveryByteIsThatOfASetWithoutScan) {
    const std::string without = files_after({});
    ContactScan closed = open_scan();
    for (const ContactGate gate : {ContactGate::NoTravel, ContactGate::PoorFloor}) {
        closed.gate = gate;
        EXPECT_EQ(files_after(closed), without);
    }
    EXPECT_NE(files_after(free_scan(2.0)), without);
}

TEST(ContactsInMaps, AScanAloneLeavesTheMoversOfTheLastCycle) {
    LocalMap map{MapParams{}};
    ObstaclePoint mover = testing::point_at(1.05, 0.45);
    mover.moving = true;
    map.insert({0.0, {}, {mover}, {}});
    map.insert(set_of(open_scan()));
    EXPECT_GT(occupancy(map.grid(), 1.05, 0.45), 0.7);
    map.insert({0.2, {}, {}, {}});
    EXPECT_NEAR(occupancy(map.grid(), 1.05, 0.45), unknown, tolerance);
}

}  // namespace
}  // namespace flownav::mapping
