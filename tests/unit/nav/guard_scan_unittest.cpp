#include <gtest/gtest.h>

#include "flownav/testing/contact_scans.h"
#include "guard_drive.h"

// What the guard makes of contact scans.
namespace flownav::nav {
namespace {

using mrpt::maps::COccupancyGridMap2D;

constexpr double view_m = 2.0;  // scans confirm floor up to here

/// A robot on floor that ends at `floor_end_m` ahead of the start; the ground beyond is unknown to the map.
/// It scans in every cycle, and `change` may alter what it sees.
class FloorDrive {
  public:
    explicit FloorDrive(double floor_end_m, std::function<void(ContactScan&)> change = {})
        : floor_end_m_(floor_end_m) {
        drive.elsewhere = 0.5F;
        drive.scan = [this, change = std::move(change)] {
            ContactScan scan = testing::open_scan();
            const double free_m = std::min(view_m, floor_end_m_ - drive.robot.pose().x_m);
            if (free_m > scan.view_near_m) testing::confirm(scan, -1.0, 1.0, free_m);
            if (change) change(scan);
            return scan;
        };
    }

    FloorDrive(const FloorDrive&) = delete;
    FloorDrive& operator=(const FloorDrive&) = delete;

    void go(double seconds) {
        drive.go(seconds, [this](Tick& tick) {
            if (tick.map != nullptr) show_floor(*tick.map);
        });
    }

    Drive drive;

  private:
    /// Ground that the scans have confirmed so far is free, and the strip below the view at the start.
    void show_floor(COccupancyGridMap2D& map) const {
        const double end_m = std::min(view_m, floor_end_m_ - drive.robot.pose().x_m);
        for (int x = map.x2idx(-0.5F); x < map.x2idx(static_cast<float>(end_m)); ++x)
            for (int y = map.y2idx(-1.0F); y < map.y2idx(1.0F); ++y) map.setCell(x, y, 0.8F);
    }

    double floor_end_m_;
};

constexpr double front_m = 0.25;  // of the default robot

TEST(GuardScan, StopsBeforeGroundInViewThatWasNotConfirmedAndDoesNotCrawlIntoIt) {
    FloorDrive floor(1.5);
    floor.go(30.0);
    EXPECT_EQ(floor.drive.safety.action, GuardAction::Stop);
    EXPECT_EQ(floor.drive.safety.reason, GuardReason::UnconfirmedAhead) << floor.drive.safety.why;
    EXPECT_GT(floor.drive.robot.pose().x_m + front_m, 1.3);
    EXPECT_LT(floor.drive.robot.pose().x_m + front_m, 1.45) << "a scan confirms floor a little too far";
    floor.drive.wish = {-0.1, 0.0};
    floor.go(1.0);
    EXPECT_LT(floor.drive.robot.motion().v_mps, 0.0) << "it may drive away";
}

TEST(GuardScan, WithoutScansItCrawlsOverUnknownGroundAsFarAsItMay) {
    FloorDrive floor(1.5);
    floor.drive.scan = {};
    floor.go(30.0);
    EXPECT_EQ(floor.drive.safety.reason, GuardReason::UnseenAhead);
    EXPECT_GT(floor.drive.robot.pose().x_m + front_m, 1.9);
}

TEST(GuardScan, OverConfirmedFloorItDrivesAtFullSpeed) {
    FloorDrive floor(100.0);
    floor.go(6.0);
    EXPECT_EQ(floor.drive.safety.action, GuardAction::Pass) << floor.drive.safety.why;
    EXPECT_NEAR(floor.drive.robot.motion().v_mps, 0.4, 1e-9);
}

TEST(GuardScan, WhileTheFloorStraightAheadIsNotConfirmedItDrivesSlowly) {
    for (const double side : {-1.0, 1.0}) {
        // The strips of one half of the cone are missing; the map knows the floor.
        bool missing = true;
        FloorDrive floor(100.0, [&](ContactScan& scan) {
            if (!missing) return;
            testing::change_strips(scan, std::min(0.0, side * 0.2), std::max(0.0, side * 0.2),
                                   [](ContactStrip& strip) { strip.kind = BeamKind::Unknown; });
        });
        floor.drive.elsewhere = 0.8F;
        floor.go(8.0);
        EXPECT_EQ(floor.drive.safety.action, GuardAction::Slow);
        EXPECT_EQ(floor.drive.safety.reason, GuardReason::UnconfirmedAhead);
        EXPECT_LE(floor.drive.robot.motion().v_mps, 0.3 + 1e-9);
        EXPECT_GT(floor.drive.robot.motion().v_mps, 0.25);
        missing = false;
        floor.go(4.0);
        EXPECT_NEAR(floor.drive.robot.motion().v_mps, 0.4, 1e-9);
    }
}

TEST(GuardScan, StripsMissingWhereOneOfItsCornersWillPassSlowItDown) {
    for (const double side : {-1.0, 1.0}) {
        FloorDrive floor(100.0, [&](ContactScan& scan) {
            testing::change_strips(scan, std::min(0.15 * side, 0.45 * side),
                                   std::max(0.15 * side, 0.45 * side),
                                   [](ContactStrip& strip) { strip.kind = BeamKind::Unknown; });
        });
        floor.drive.elsewhere = 0.8F;
        floor.go(8.0);
        EXPECT_EQ(floor.drive.safety.reason, GuardReason::UnconfirmedAhead);
        EXPECT_LE(floor.drive.robot.motion().v_mps, 0.3 + 1e-9);
        EXPECT_GT(floor.drive.robot.motion().v_mps, 0.25);
    }
}

TEST(GuardScan, StripsMissingBesideItsWayDoNotSlowItDown) {
    FloorDrive floor(100.0, [](ContactScan& scan) {
        testing::change_strips(scan, 0.5, 1.0, [](ContactStrip& strip) { strip.kind = BeamKind::Unknown; });
    });
    floor.drive.elsewhere = 0.8F;
    floor.go(6.0);
    EXPECT_NEAR(floor.drive.robot.motion().v_mps, 0.4, 1e-9);
}

TEST(GuardScan, OnFloorWithoutTextureItDrivesSlowlyOverGroundThatScansLookedAt) {
    FloorDrive floor(0.0);
    floor.go(30.0);
    EXPECT_GT(floor.drive.robot.pose().x_m, 4.0) << floor.drive.safety.why;
    EXPECT_LE(floor.drive.robot.motion().v_mps, 0.3 + 1e-9);
    EXPECT_GT(floor.drive.robot.motion().v_mps, 0.2);
}

TEST(GuardScan, OnFloorWithoutTextureItCrawlsWhereNoStripShowsAnything) {
    FloorDrive floor(0.0, [](ContactScan& scan) {
        for (ContactStrip& strip : scan.strips) strip.seen = false;
    });
    floor.go(30.0);
    EXPECT_EQ(floor.drive.safety.reason, GuardReason::UnseenAhead);
    EXPECT_LT(floor.drive.robot.pose().x_m, 1.0) << "as far as it may crawl, not farther";
}

TEST(GuardScan, AfterATurnItCrawlsUntilAScanLooksWhereItGoes) {
    FloorDrive floor(100.0);
    floor.drive.elsewhere = 0.8F;
    floor.go(4.0);
    for (const double omega_radps : {0.5, -0.5}) {
        floor.drive.wish = {0.0, omega_radps};
        const auto scan = floor.drive.scan;
        floor.drive.scan = {};  // scans need travel
        floor.go(2.0);
        floor.drive.wish = {0.4, 0.0};
        floor.go(1.0);
        EXPECT_EQ(floor.drive.safety.reason, GuardReason::UnconfirmedAhead) << floor.drive.safety.why;
        EXPECT_LE(floor.drive.robot.motion().v_mps, 0.1 + 1e-9);
        floor.drive.scan = scan;
        floor.go(3.0);
        EXPECT_NEAR(floor.drive.robot.motion().v_mps, 0.4, 1e-9);
    }
}

TEST(GuardScan, WithTheGateClosedGroundIsUnknownAndNeverUnconfirmed) {
    for (const ContactGate gate : {ContactGate::PoorFloor, ContactGate::NoTravel}) {
        FloorDrive floor(1.5, [gate](ContactScan& scan) { scan.gate = gate; });
        floor.go(30.0);
        EXPECT_EQ(floor.drive.safety.reason, GuardReason::UnseenAhead);
        EXPECT_GT(floor.drive.robot.pose().x_m + front_m, 1.9) << "as without scans";
        floor.drive.elsewhere = 0.8F;
        floor.go(6.0);
        EXPECT_NEAR(floor.drive.robot.motion().v_mps, 0.3, 0.02) << "slow over ground seen otherwise";
    }
}

TEST(GuardScan, AMinuteAfterTheLastScanItMayCreepOn) {
    FloorDrive floor(1.5);
    floor.go(10.0);
    const double stood_m = floor.drive.robot.pose().x_m;
    floor.drive.scan = {};  // a standing robot scans nothing
    floor.go(45.0);
    EXPECT_NEAR(floor.drive.robot.pose().x_m, stood_m, 1e-9);
    floor.go(30.0);
    EXPECT_GT(floor.drive.robot.pose().x_m, stood_m + 0.1);
}

}  // namespace
}  // namespace flownav::nav
