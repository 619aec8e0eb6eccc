#include "flownav/nav/motion_model.h"

#include <gtest/gtest.h>

namespace flownav::nav {
namespace {

TEST(MotionModel, TheSpeedThatStopsInTimeInvertsTheStoppingDistance) {
    const RobotModel robot;
    for (const double v_mps : {0.05, 0.4, 1.0, 2.0}) {
        EXPECT_NEAR(stoppable_speed_mps(robot, stopping_distance_m(robot, v_mps)), v_mps, 1e-12);
    }
    EXPECT_EQ(stoppable_speed_mps(robot, -0.1), 0.0);
}

}  // namespace
}  // namespace flownav::nav
