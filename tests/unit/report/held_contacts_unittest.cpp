#include "flownav/report/held_contacts.h"

#include <gtest/gtest.h>

#include "flownav/report/contact_segments.h"
#include "step_samples.h"

namespace flownav::report {
namespace {

using testing::step_at;

/// A step without a new scan.
pipeline::Step step_from(const Pose2& T_start_robot) {
    pipeline::Step step;
    step.T_start_robot = T_start_robot;
    return step;
}

pipeline::Step scanned_from(const Pose2& T_start_robot) {
    pipeline::Step step = step_at(4);
    step.T_start_robot = T_start_robot;
    return step;
}

Eigen::Vector2d first_contact_m(const HeldContacts& held) {
    return contact_segments(held.scan(), Pose2{}).at(0).near_m;
}

TEST(HeldContacts, ThereIsNoneBeforeTheFirstScan) {
    HeldContacts held;
    held.take(step_from({}));
    EXPECT_EQ(held.scan().gate, ContactGate::Off);
    EXPECT_TRUE(held.scan().strips.empty());
}

TEST(HeldContacts, APlaceComesNearerWhileTheRobotDrivesOn) {
    HeldContacts held;
    held.take(scanned_from({1.0, 2.0, 0.0}));
    const Eigen::Vector2d before_m = first_contact_m(held);
    held.take(step_from({1.1, 2.0, 0.0}));
    held.take(step_from({1.3, 2.0, 0.0}));
    EXPECT_LT((first_contact_m(held) - before_m - Eigen::Vector2d(-0.3, 0.0)).norm(), 1e-12);
}

TEST(HeldContacts, APlaceMovesToTheRightWhileTheRobotTurnsLeft) {
    HeldContacts held;
    held.take(scanned_from({}));
    const Eigen::Vector2d before_m = first_contact_m(held);
    held.take(step_from({0.0, 0.0, 0.1}));
    EXPECT_LT(first_contact_m(held).y(), before_m.y());
}

TEST(HeldContacts, ANewScanReplacesTheHeldOneAlsoWhenItsGateIsClosed) {
    HeldContacts held;
    held.take(scanned_from({}));
    pipeline::Step closed = step_from({});
    closed.new_contacts = true;
    closed.contacts.gate = ContactGate::NoTravel;
    held.take(closed);
    EXPECT_EQ(held.scan().gate, ContactGate::NoTravel);
    EXPECT_TRUE(contact_segments(held.scan(), Pose2{}).empty());
}

TEST(HeldContacts, ARestartDropsTheScan) {
    HeldContacts held;
    held.take(scanned_from({}));
    pipeline::Step restart = step_from({});
    restart.restarted = true;
    held.take(restart);
    EXPECT_TRUE(held.scan().strips.empty());
}

TEST(ContactSegments, AContactOnTheRightHasANegativeYAndIsAsWideAsItsStrip) {
    const std::vector<ContactSegment> segments = contact_segments(step_at(4).contacts, Pose2{});
    ASSERT_EQ(segments.size(), 3U);
    const ContactSegment& wall = segments[1];
    EXPECT_EQ(wall.cause, BeamCause::Wall);
    EXPECT_LT((wall.right_m - Eigen::Vector2d(2.1, 0.05 - 0.4)).norm(), 1e-12);
    EXPECT_LT((wall.left_m - Eigen::Vector2d(2.1, 0.05 - 0.2)).norm(), 1e-12);
    EXPECT_NEAR(wall.near_m.x(), 2.0, 1e-12);
    EXPECT_NEAR(wall.far_m.x(), 2.3, 1e-12);
    EXPECT_GT(segments[0].left_m.y(), 0.0) << "a negative tangent is to the left";
}

TEST(ContactSegments, AreInTheFrameOfTheMap) {
    const ContactScan scan = step_at(4).contacts;
    const Pose2 robot{3.0, -2.0, M_PI / 2};  // looks along y
    const ContactSegment wall = contact_segments(scan, robot)[1];
    EXPECT_LT((wall.right_m - Eigen::Vector2d(3.0 + 0.35, -2.0 + 2.1)).norm(), 1e-12);
}

}  // namespace
}  // namespace flownav::report
