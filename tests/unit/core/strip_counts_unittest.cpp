#include "flownav/core/strip_counts.h"

#include <gtest/gtest.h>

namespace flownav {
namespace {

ContactStrip free_to(double free_m) {
    ContactStrip strip;
    strip.kind = BeamKind::Free;
    strip.free_m = free_m;
    strip.seen = true;
    return strip;
}

ContactStrip blocked_at(double contact_m, BeamCause cause, double free_m) {
    ContactStrip strip = free_to(free_m);
    strip.kind = BeamKind::Obstacle;
    strip.cause = cause;
    strip.contact_m = contact_m;
    return strip;
}

ContactScan scan_of(std::vector<ContactStrip> strips) {
    ContactScan scan;
    scan.gate = ContactGate::Open;
    scan.strips = std::move(strips);
    return scan;
}

TEST(StripCounts, CountEveryStripOnceByItsKind) {
    const StripCounts counts =
        counts_of(scan_of({free_to(1.0), free_to(3.0), {}, blocked_at(1.5, BeamCause::Votes, 1.0)}));
    EXPECT_EQ(counts.free, 2);
    EXPECT_EQ(counts.obstacle, 1);
    EXPECT_EQ(counts.unknown, 1);
}

TEST(StripCounts, ObstaclesAreCountedByTheirCause) {
    const StripCounts counts = counts_of(scan_of({blocked_at(1.0, BeamCause::Wall, 0.0),
                                                  blocked_at(1.0, BeamCause::Wall, 0.0),
                                                  blocked_at(1.0, BeamCause::Drop, 0.0),
                                                  blocked_at(1.0, BeamCause::Votes, 0.0),
                                                  {}}));
    EXPECT_EQ(counts.by_cause, (std::array<int, 5>{0, 0, 1, 2, 1}));
}

TEST(StripCounts, AStripIsDecidedByAnObstacleWithinTwoMetresOrByFloorUpToThere) {
    EXPECT_EQ(counts_of(scan_of({free_to(2.0)})).decided, 1);
    EXPECT_EQ(counts_of(scan_of({free_to(1.9)})).decided, 0);
    EXPECT_EQ(counts_of(scan_of({blocked_at(1.9, BeamCause::Votes, 0.5)})).decided, 1);
    EXPECT_EQ(counts_of(scan_of({blocked_at(2.5, BeamCause::Votes, 1.0)})).decided, 0);
    EXPECT_EQ(counts_of(scan_of({blocked_at(2.5, BeamCause::Votes, 2.4)})).decided, 1);
}

TEST(StripCounts, AnUnknownStripIsInViewWhenItWasSeen) {
    ContactStrip seen;
    seen.seen = true;
    const StripCounts counts = counts_of(scan_of({seen, {}, free_to(1.0)}));
    EXPECT_EQ(counts.in_view, 2);
    EXPECT_EQ(counts.decided, 0);
}

}  // namespace
}  // namespace flownav
