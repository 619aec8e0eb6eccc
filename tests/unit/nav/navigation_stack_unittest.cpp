#include "flownav/nav/navigation_stack.h"

#include <gtest/gtest.h>

#include "flownav/mapping/export.h"
#include "flownav/mapping/grid_area.h"
#include "flownav/testing/contact_scans.h"

// How contact scans reach maps, planner and guard.
namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using testing::block;
using testing::block_at;

class StandingNavigator : public Navigator {
  public:
    Decision decide(const Situation& /*situation*/, const Vector2d& /*waypoint_m*/) override { return {}; }
};

NavigationStack stack() {
    RecoveryManager recovery(RobotModel{}, RecoveryParams{}, std::make_unique<StandingNavigator>(),
                             std::vector<Vector2d>{{5.0, 0.0}});
    NavigationStack stack(NavigationParams{}, mapping::MapParams{}, GuardParams{}, std::move(recovery),
                          Pose2{});
    stack.odometry(0.0, Pose2{}, {});
    return stack;
}

/// A field that ends no cycle, with a contact scan.
SensorUpdate update_with(const ContactScan& contacts) {
    SensorUpdate update;
    update.report.timestamp_s = 0.1;
    update.contacts = contacts;
    return update;
}

double p_free(const mrpt::maps::COccupancyGridMap2D& map, double x_m, double y_m) {
    return mapping::p_free_at(map, mapping::area_of(map), {x_m, y_m});
}

TEST(NavigationStack, AScanThatComesBetweenTwoCyclesReachesBothMaps) {
    ContactScan scan = testing::open_scan();
    block_at(scan, 0.2, 0.3, 2.05);
    NavigationStack navigation = stack();
    for (int i = 0; i < 2; ++i) navigation.update(update_with(scan));
    EXPECT_LT(p_free(navigation.local_map(), 2.05, -0.55), 0.3);
    EXPECT_LT(p_free(navigation.map(), 2.05, -0.55), 0.3);
    EXPECT_NEAR(p_free(navigation.map(), 2.05, 0.55), 0.5, 0.01) << "right is right";
}

TEST(NavigationStack, AClosedScanChangesNoByteOfTheMaps) {
    SensorUpdate cycle;
    cycle.report.end_of_cycle = true;
    cycle.ground.push_back({{0.5, 0.0}, {2.0, 0.0}, 1.0});
    NavigationStack with = stack();
    NavigationStack without = stack();
    ContactScan closed;
    closed.gate = ContactGate::NoTravel;
    for (int i = 0; i < 5; ++i) {
        cycle.report.timestamp_s = 0.2 * i;
        without.update(cycle);
        with.update(cycle);
        with.update(update_with(closed));
    }
    EXPECT_EQ(mapping::export_map(with.map()).gridmap, mapping::export_map(without.map()).gridmap);
    EXPECT_EQ(mapping::export_map(with.local_map()).gridmap,
              mapping::export_map(without.local_map()).gridmap);
}

TEST(NavigationStack, APlanLeadsAroundADropThatWasSeenOnce) {
    // The rim is seen at 1.55 m, from 1.1 m to the left to 1.1 m to the right.
    ContactScan scan = testing::open_scan();
    block(scan, -0.7, 0.7, 1.55, BeamCause::Drop);
    NavigationStack navigation = stack();
    navigation.update(update_with(scan));
    const RobotModel robot;
    const Plan around = plan(navigation.map(), {0.0, 0.0}, {3.0, 0.0}, robot, PlanParams{});
    EXPECT_TRUE(around.reaches_goal);
    for (const Vector2d& p : around.path_m) {
        EXPECT_FALSE(std::abs(p.x() - 1.55) < 0.1 && std::abs(p.y()) < 1.05) << p.transpose();
    }
}

}  // namespace
}  // namespace flownav::nav
