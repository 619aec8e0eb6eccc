#include "flownav/obstacles/drops.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flownav::obstacles {
namespace {

/// An open scan with floor up to 1.5 m in every strip.
ContactScan floor_to_the_rim() {
    ContactScan scan;
    scan.gate = ContactGate::Open;
    scan.first = -20;
    scan.strips.resize(40);
    for (ContactStrip& strip : scan.strips) {
        strip.kind = BeamKind::Free;
        strip.free_m = 1.5;
        strip.seen = true;
    }
    return scan;
}

/// Five blocks on one line of sight, from 1.8 m on.
std::vector<Eigen::Vector2d> short_blocks(double right) {
    std::vector<Eigen::Vector2d> blocks;
    for (int i = 0; i < 5; ++i) blocks.emplace_back(1.8 + 0.1 * i, right * (1.8 + 0.1 * i));
    return blocks;
}

int drops(const ContactScan& scan, double from, double to) {
    int count = 0;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        const double right = middle_tangent(scan, i);
        count +=
            right > from && right < to && scan.strips[static_cast<std::size_t>(i)].cause == BeamCause::Drop;
    }
    return count;
}

TEST(Drops, TheFloorEndsAtTheRim) {
    ContactScan scan = floor_to_the_rim();
    std::vector<double> buffer;
    mark_drops(short_blocks(0.025), buffer, scan);
    const ContactStrip& ahead = scan.strips[20];
    EXPECT_EQ(ahead.kind, BeamKind::Obstacle);
    EXPECT_EQ(ahead.cause, BeamCause::Drop);
    EXPECT_DOUBLE_EQ(ahead.contact_m, 1.5);
    EXPECT_DOUBLE_EQ(ahead.free_m, 1.5);
}

TEST(Drops, ADropOnTheRightIsOnTheRight) {
    ContactScan scan = floor_to_the_rim();
    std::vector<double> buffer;
    mark_drops(short_blocks(0.5), buffer, scan);
    EXPECT_GT(drops(scan, 0.4, 0.6), 0);
    EXPECT_EQ(drops(scan, -1.0, 0.3), 0);
}

TEST(Drops, ADropOnTheLeftIsOnTheLeft) {
    ContactScan scan = floor_to_the_rim();
    std::vector<double> buffer;
    mark_drops(short_blocks(-0.5), buffer, scan);
    EXPECT_GT(drops(scan, -0.6, -0.4), 0);
    EXPECT_EQ(drops(scan, -0.3, 1.0), 0);
}

TEST(Drops, ThreeShortBlocksAreNoDrop) {
    ContactScan scan = floor_to_the_rim();
    std::vector<Eigen::Vector2d> blocks = short_blocks(0.025);
    blocks.resize(3);
    std::vector<double> buffer;
    mark_drops(blocks, buffer, scan);
    EXPECT_EQ(drops(scan, -1.0, 1.0), 0);
}

TEST(Drops, ShortBlocksFarFromEachOtherAreNoDrop) {
    ContactScan scan = floor_to_the_rim();
    std::vector<Eigen::Vector2d> blocks;
    for (int i = 0; i < 5; ++i) blocks.emplace_back(1.2 + 0.5 * i, 0.0);
    std::vector<double> buffer;
    mark_drops(blocks, buffer, scan);
    EXPECT_EQ(drops(scan, -1.0, 1.0), 0);
}

TEST(Drops, FloorThatIsSeenFarBehindDoesNotMoveTheRimThere) {
    ContactScan scan = floor_to_the_rim();
    for (ContactStrip& strip : scan.strips) strip.free_m = 3.0;
    std::vector<double> buffer;
    mark_drops(short_blocks(0.025), buffer, scan);
    EXPECT_NEAR(scan.strips[20].contact_m, 1.7, 1e-9);
    EXPECT_NEAR(scan.strips[20].free_m, 1.7, 1e-9);
}

TEST(Drops, AnObstacleBeforeTheRimStays) {
    ContactScan scan = floor_to_the_rim();
    scan.strips[20].kind = BeamKind::Obstacle;
    scan.strips[20].cause = BeamCause::Votes;
    scan.strips[20].contact_m = scan.strips[20].near_m = scan.strips[20].far_m = 1.0;
    std::vector<double> buffer;
    mark_drops(short_blocks(0.025), buffer, scan);
    EXPECT_EQ(scan.strips[20].cause, BeamCause::Votes);
}

TEST(Drops, AClosedGateShowsNone) {
    ContactScan scan = floor_to_the_rim();
    scan.gate = ContactGate::PoorFloor;
    std::vector<double> buffer;
    mark_drops(short_blocks(0.025), buffer, scan);
    EXPECT_EQ(drops(scan, -1.0, 1.0), 0);
}

}  // namespace
}  // namespace flownav::obstacles
