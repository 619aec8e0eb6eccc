#include "flownav/drive/sensor_feed.h"

#include <gtest/gtest.h>

#include "flownav/testing/contact_scans.h"

namespace flownav::drive {
namespace {

nav::SensorUpdate update_of(const pipeline::Step& step) {
    pipeline::RepeatedImages images;
    return sensor_update_of(step, Field{}, images);
}

TEST(SensorFeed, PassesPointsAndFloorAtTheEndOfACycleOnly) {
    pipeline::Step step;
    step.obstacles.resize(2);
    step.ground.resize(3);
    EXPECT_TRUE(update_of(step).points.empty());
    step.end_of_cycle = true;
    EXPECT_EQ(update_of(step).points.size(), 2U);
    EXPECT_EQ(update_of(step).ground.size(), 3U);
}

TEST(SensorFeed, PassesAContactScanWithTheFieldThatItIsNewWith) {
    pipeline::Step step;
    step.contacts = testing::free_scan(2.0);
    step.contacts.T_robot_scan.x_m = -0.1;
    EXPECT_EQ(update_of(step).contacts.gate, ContactGate::Off) << "it is that of an earlier field";
    step.new_contacts = true;
    const nav::SensorUpdate update = update_of(step);
    EXPECT_EQ(update.contacts.gate, ContactGate::Open);
    EXPECT_EQ(update.contacts.strips.size(), step.contacts.strips.size());
    EXPECT_EQ(update.contacts.T_robot_scan.x_m, -0.1);
}

}  // namespace
}  // namespace flownav::drive
