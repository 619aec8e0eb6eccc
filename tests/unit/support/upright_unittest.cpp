#include "flownav/testing/upright.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace flownav::testing {
namespace {

TEST(Upright, ComesBackFromItsSolid) {
    for (const UprightShape shape : {UprightShape::Box, UprightShape::Cylinder}) {
        Upright u;
        u.shape = shape;
        u.centre_m = {1.0, -2.0};
        u.z_low_m = 0.43;
        u.z_high_m = 0.47;
        u.half_x_m = 0.3;
        u.half_y_m = shape == UprightShape::Box ? 0.2 : 0.0;
        u.yaw_rad = 0.7;
        const Upright back = upright_of(solid_of(u, {}));
        EXPECT_EQ(back.shape, u.shape);
        EXPECT_EQ(back.centre_m, u.centre_m);
        EXPECT_DOUBLE_EQ(back.z_low_m, u.z_low_m);
        EXPECT_DOUBLE_EQ(back.z_high_m, u.z_high_m);
        EXPECT_EQ(back.half_x_m, u.half_x_m);
        EXPECT_EQ(back.half_y_m, u.half_y_m);
        EXPECT_DOUBLE_EQ(back.yaw_rad, u.yaw_rad);
    }
}

TEST(Upright, SpheresAndTiltedSolidsAreRefused) {
    Solid sphere;
    sphere.shape = sim::Sphere{};
    EXPECT_THROW(upright_of(sphere), std::invalid_argument);
    Solid tilted;
    tilted.T_world_solid.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
    EXPECT_THROW(upright_of(tilted), std::invalid_argument);
}

TEST(Upright, MovesWithItsVelocityFromBeforeTimeZeroOn) {
    Solid solid = solid_of({}, {});
    set_velocity(solid, {0.5, -1.0}, 4.0);
    World world;
    world.solids = {solid};
    for (const double time_s : {-0.02, 0.0, 3.0}) {
        const Upright moved = upright_of(at_time(world, time_s).solids.front());
        EXPECT_NEAR(moved.centre_m.x(), 0.5 * time_s, 1e-12);
        EXPECT_NEAR(moved.centre_m.y(), -1.0 * time_s, 1e-12);
    }
}

TEST(Upright, DistanceIsToItsTurnedOutline) {
    Upright u;
    u.yaw_rad = M_PI / 2;
    u.half_x_m = 1.0;
    u.half_y_m = 0.25;
    EXPECT_NEAR(distance_m(solid_of(u, {}), {0.5, 0.0}), 0.25, 1e-12);
    EXPECT_EQ(distance_m(solid_of(u, {}), {0.0, 0.9}), 0.0);
}

}  // namespace
}  // namespace flownav::testing
