#include "flownav/replay/obstacle_set.h"

#include <gtest/gtest.h>

#include "flownav/testing/contact_scans.h"

namespace flownav::replay {
namespace {

TEST(ObstacleSet, AContactScanIsTakenWithTheRecordThatItIsNewWith) {
    pipeline::Step step;
    step.timestamp_s = 7.0;
    step.T_start_robot = {1.0, 2.0, 0.3};
    step.obstacles.resize(2);
    step.contacts = testing::free_scan(2.0);
    EXPECT_FALSE(is_new_for_map(step));
    step.new_contacts = true;
    EXPECT_TRUE(is_new_for_map(step));
    mapping::ObstacleSet set;
    copy_surroundings(step, set);
    EXPECT_EQ(set.timestamp_s, 7.0);
    EXPECT_EQ(set.T_map_robot.y_m, 2.0);
    EXPECT_EQ(set.points.size(), 2U);
    EXPECT_EQ(set.contacts.gate, ContactGate::Open);
    EXPECT_EQ(set.contacts.strips.size(), step.contacts.strips.size());
}

TEST(ObstacleSet, TheScanOfAnEarlierRecordIsNotTakenAgain) {
    pipeline::Step step;
    step.contacts = testing::free_scan(2.0);
    step.new_contacts = true;
    mapping::ObstacleSet set;
    copy_surroundings(step, set);
    step.new_contacts = false;
    step.end_of_cycle = true;
    copy_surroundings(step, set);
    EXPECT_EQ(set.contacts.gate, ContactGate::Off);
    EXPECT_TRUE(set.contacts.strips.empty());
    EXPECT_TRUE(mapping::is_empty(set));
}

}  // namespace
}  // namespace flownav::replay
