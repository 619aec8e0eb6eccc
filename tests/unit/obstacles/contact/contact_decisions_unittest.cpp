#include "contact_decisions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace flownav::obstacles {
namespace {

/// Ten scans, 0.15 m apart, that see a wall across the way; `wall_m(way_m)` ahead of the camera. Returns the
/// number of the first scan that says so; 0: none does.
template <class WallAt>
int first_scan_with_wall(const WallAt& wall_m) {
    constexpr double step_m = 0.15;
    ContactMemory memory;
    for (int scan = 1; scan <= 10; ++scan) {
        memory.keys.push().T_start_robot.x_m = step_m * scan;
        memory.scans = scan;
        StripEvidence evidence;
        evidence.wall_m = wall_m(step_m * scan);
        memory.evidence.assign(8, evidence);
        ContactScan out;
        out.first = -4;
        out.step = 0.05;
        out.strips.assign(8, ContactStrip{});
        decide_obstacles(memory, {}, out);
        const auto is_wall = [](const ContactStrip& strip) { return strip.kind == BeamKind::Obstacle; };
        if (std::any_of(out.strips.begin(), out.strips.end(), is_wall)) return scan;
    }
    return 0;
}

TEST(ContactDecisions, AWallIsOneOnceItWasSeenAtItsPlaceFromFartherAway) {
    EXPECT_EQ(first_scan_with_wall([](double way_m) { return 4.0 - way_m; }), 3);
}

TEST(ContactDecisions, WhereTheTextureOfTheFloorEndsThereIsNoWallAsLongAsThatMovesOnWithTheRobot) {
    EXPECT_EQ(first_scan_with_wall([](double) { return 2.1; }), 0);
}

TEST(ContactDecisions, ANearWallNeedsNoEarlierSight) {
    EXPECT_EQ(first_scan_with_wall([](double) { return 0.9; }), 1);
}

}  // namespace
}  // namespace flownav::obstacles
