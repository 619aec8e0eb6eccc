#include "flownav/sim/world.h"

#include <gtest/gtest.h>

namespace flownav::sim {
namespace {

Eigen::Isometry3d at(double x_m, double yaw_rad) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translate(Eigen::Vector3d(x_m, 0.0, 0.5));
    pose.rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
    return pose;
}

TEST(World, AThingWithoutAScriptStaysWhereItIs) {
    Solid solid;
    solid.T_world_solid = at(3.0, 0.1);
    EXPECT_TRUE(pose_at(solid, 100.0).isApprox(at(3.0, 0.1)));
}

TEST(World, AScriptedThingWaitsMovesLinearlyAndRests) {
    Solid solid;
    solid.script = {{1.0, at(0.0, 0.0)}, {3.0, at(4.0, 1.0)}};
    EXPECT_TRUE(pose_at(solid, 0.0).isApprox(at(0.0, 0.0)));
    EXPECT_TRUE(pose_at(solid, 1.5).isApprox(at(1.0, 0.25)));
    EXPECT_TRUE(pose_at(solid, 9.0).isApprox(at(4.0, 1.0)));
}

}  // namespace
}  // namespace flownav::sim
