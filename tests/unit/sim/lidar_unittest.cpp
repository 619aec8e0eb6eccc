#include "flownav/sim/lidar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "flownav/math/units.h"

namespace flownav::sim {
namespace {

Solid thing(const Shape& shape, double x_m, double y_m, double z_m) {
    Solid solid;
    solid.shape = shape;
    solid.T_world_solid.translate(Eigen::Vector3d(x_m, y_m, z_m));
    return solid;
}

World world_of(const Shape& shape, double x_m, double y_m, double z_m = 0.5) {
    World world;
    world.solids.push_back(thing(shape, x_m, y_m, z_m));
    return world;
}

/// 5 beams from right to left.
LidarParams five_beams() {
    LidarParams params;
    params.field_of_view_deg = 180.0;
    params.beams = 5;
    return params;
}

void expect_beam(const VirtualScan& scan, std::size_t i, BeamKind kind, double range_m) {
    EXPECT_EQ(scan.beams[i].kind, kind) << i;
    EXPECT_NEAR(scan.beams[i].range_m, range_m, 1e-12) << i;
}

TEST(Lidar, SeesNothingInAnEmptyWorldUpToItsRange) {
    const VirtualScan seen = scan({}, five_beams(), {}, 0.0);
    ASSERT_EQ(seen.beams.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) expect_beam(seen, i, BeamKind::Free, 8.0);
    EXPECT_NEAR(seen.first_bearing_rad, -M_PI / 2, 1e-12);
    EXPECT_NEAR(seen.step_rad, M_PI / 4, 1e-12);
}

TEST(Lidar, MeasuresToTheSurfaceAhead) {
    expect_beam(scan(world_of(Cylinder{0.5, 1.0}, 3.0, 0.0), five_beams(), {}, 0.0), 2, BeamKind::Obstacle,
                2.5);
    expect_beam(scan(world_of(Box{{1.0, 0.2, 1.0}}, 3.0, 0.0), five_beams(), {}, 0.0), 2, BeamKind::Obstacle,
                2.5);
    expect_beam(scan(world_of(Sphere{0.5}, 3.0, 0.0, 0.3), five_beams(), {}, 0.0), 2, BeamKind::Obstacle,
                2.5);
}

TEST(Lidar, TheLastBeamIsOnTheLeft) {
    const VirtualScan seen = scan(world_of(Cylinder{0.5, 1.0}, 0.0, 3.0), five_beams(), {}, 0.0);
    expect_beam(seen, 4, BeamKind::Obstacle, 2.5);
    expect_beam(seen, 0, BeamKind::Free, 8.0);
}

TEST(Lidar, BearingsAreTheRobots) {
    const World world = world_of(Cylinder{0.5, 1.0}, 1.0, 4.0);
    expect_beam(scan(world, five_beams(), {1.0, 1.0, M_PI / 2}, 0.0), 2, BeamKind::Obstacle, 2.5);
    expect_beam(scan(world, five_beams(), {1.0, 1.0, M_PI}, 0.0), 0, BeamKind::Obstacle, 2.5);
}

TEST(Lidar, TheNearerThingHidesTheFarther) {
    World world = world_of(Cylinder{0.5, 1.0}, 5.0, 0.0);
    world.solids.push_back(thing(Cylinder{0.1, 1.0}, 2.0, 0.0, 0.5));
    world.solids.push_back(thing(Box{{0.1, 0.1, 1.0}}, 4.0, 0.0, 0.5));
    expect_beam(scan(world, five_beams(), {}, 0.0), 2, BeamKind::Obstacle, 1.9);
}

TEST(Lidar, DoesNotSeeWhatIsBelowOrAboveItsPlaneOrTooFar) {
    expect_beam(scan(world_of(Box{{1.0, 1.0, 0.2}}, 3.0, 0.0, 0.1), five_beams(), {}, 0.0), 2, BeamKind::Free,
                8.0);
    expect_beam(scan(world_of(Box{{1.0, 1.0, 0.2}}, 3.0, 0.0, 0.9), five_beams(), {}, 0.0), 2, BeamKind::Free,
                8.0);
    expect_beam(scan(world_of(Cylinder{0.5, 1.0}, 8.6, 0.0), five_beams(), {}, 0.0), 2, BeamKind::Free, 8.0);
}

TEST(Lidar, InsideAThingItSeesItEverywhere) {
    for (const Shape& shape : {Shape(Cylinder{0.5, 1.0}), Shape(Box{{1.0, 1.0, 1.0}})}) {
        const VirtualScan seen = scan(world_of(shape, 0.1, 0.0), five_beams(), {}, 0.0);
        for (std::size_t i = 0; i < 5; ++i) expect_beam(seen, i, BeamKind::Obstacle, 0.0);
    }
}

TEST(Lidar, FollowsMovers) {
    World world = world_of(Cylinder{0.5, 1.0}, 0.0, 0.0);
    world.solids[0].script = {{0.0, thing(Cylinder{}, 3.0, 0.0, 0.5).T_world_solid},
                              {2.0, thing(Cylinder{}, 5.0, 0.0, 0.5).T_world_solid}};
    expect_beam(scan(world, five_beams(), {}, 1.0), 2, BeamKind::Obstacle, 3.5);
}

TEST(Lidar, AFullTurnHasEveryDirectionOnce) {
    LidarParams params;
    params.field_of_view_deg = 360.0;
    params.beams = 8;
    const VirtualScan seen = scan(world_of(Cylinder{0.5, 1.0}, -3.0, 0.0), params, {}, 0.0);
    EXPECT_NEAR(seen.step_rad, M_PI / 4, 1e-12);
    EXPECT_NEAR(wrap_angle(seen.first_bearing_rad - seen.step_rad * 1),
                wrap_angle(seen.first_bearing_rad + 7 * seen.step_rad), 1e-9);
}

TEST(Lidar, SeesAThingThatLiesAcrossTheBackwardDirection) {
    LidarParams params;
    params.field_of_view_deg = 360.0;
    params.beams = 36;
    const VirtualScan seen = scan(world_of(Cylinder{1.0, 1.0}, -3.0, 0.0), params, {}, 0.0);
    // The nearest beams are 5 degrees off straight back; the solid covers asin(1/3) = 19.5 degrees to either
    // side.
    const double range_m =
        3.0 * std::cos(5 * degree_rad) - std::sqrt(1 - std::pow(3.0 * std::sin(5 * degree_rad), 2));
    expect_beam(seen, 0, BeamKind::Obstacle, range_m);
    expect_beam(seen, 35, BeamKind::Obstacle, range_m);
    EXPECT_EQ(seen.beams[1].kind, BeamKind::Obstacle);
    EXPECT_EQ(seen.beams[34].kind, BeamKind::Obstacle);
    EXPECT_EQ(seen.beams[2].kind, BeamKind::Free);
    EXPECT_EQ(seen.beams[33].kind, BeamKind::Free);
}

TEST(Lidar, RefusesParamsWithoutSense) {
    LidarParams params;
    params.beams = 1;
    EXPECT_THROW(scan({}, params, {}, 0.0), std::invalid_argument);
    params = {};
    params.range_max_m = 0.0;
    EXPECT_THROW(scan({}, params, {}, 0.0), std::invalid_argument);
    params = {};
    params.field_of_view_deg = 400.0;
    EXPECT_THROW(scan({}, params, {}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace flownav::sim
