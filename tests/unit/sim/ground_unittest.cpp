#include "flownav/sim/ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"
#include "flownav/sim/collision.h"
#include "flownav/sim/lidar.h"
#include "flownav/sim/passable.h"
#include "flownav/sim/ray_caster.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

GroundPiece level(const Vector2d& low_m, const Vector2d& high_m, double height_m) {
    GroundPiece piece;
    piece.name = "piece";
    piece.T_world_ground.translate(
        Vector3d((low_m.x() + high_m.x()) / 2, (low_m.y() + high_m.y()) / 2, height_m));
    piece.size_m = high_m - low_m;
    return piece;
}

/// A ramp along x over y = -2..2 that rises from the floor at `foot_m` to `rise_m` at `top_m`.
GroundPiece ramp(double foot_m, double top_m, double rise_m) {
    GroundPiece piece;
    piece.name = "ramp";
    piece.T_world_ground.translate(Vector3d((foot_m + top_m) / 2, 0.0, rise_m / 2));
    piece.T_world_ground.rotate(Eigen::AngleAxisd(-std::atan(rise_m / (top_m - foot_m)), Vector3d::UnitY()));
    piece.size_m = {std::hypot(top_m - foot_m, rise_m), 4.0};
    return piece;
}

World world_of(std::vector<GroundPiece> ground) {
    World world;
    world.ground = std::move(ground);
    return world;
}

/// A hole 0.17 m deep from x = 1 to 2, y = -1 to 1.
World hole() {
    return world_of({level({1.0, -1.0}, {2.0, 1.0}, -0.17)});
}

constexpr double rise_m = 0.3;

/// Up from x = 1 to 4, a platform to x = 6, down to x = 9: 5.7 degrees.
World over_a_platform() {
    return world_of({ramp(1.0, 4.0, rise_m), level({4.0, -2.0}, {6.0, 2.0}, rise_m), ramp(9.0, 6.0, rise_m)});
}

TEST(Ground, IsTheHighestPieceAndTheFloorBesideThem) {
    const World world = world_of({level({0.0, 0.0}, {2.0, 2.0}, -0.3), level({1.0, 0.0}, {2.0, 2.0}, 0.2)});
    EXPECT_EQ(ground_height_m(world, {-0.1, 1.0}), 0.0);
    EXPECT_EQ(ground_height_m(world, {0.5, 1.0}), -0.3);
    EXPECT_EQ(ground_height_m(world, {1.5, 1.0}), 0.2);
}

TEST(Ground, OfARampRisesWithItsSlope) {
    const World world = over_a_platform();
    EXPECT_NEAR(ground_height_m(world, {1.0, 0.0}), 0.0, 1e-9);
    EXPECT_NEAR(ground_height_m(world, {2.5, 0.0}), rise_m / 2, 1e-9);
    EXPECT_NEAR(ground_height_m(world, {5.0, 0.0}), rise_m, 1e-9);
    EXPECT_NEAR(ground_height_m(world, {8.0, 0.0}), rise_m / 3, 1e-9);
}

TEST(GroundSteps, AddUpOnTheWayAndLeaveOutSlopes) {
    const World world = hole();
    EXPECT_NEAR(ground_steps_m(world, {0.5, 0.0}, {1.5, 0.0}), -0.17, 1e-12);
    EXPECT_NEAR(ground_steps_m(world, {1.5, 0.0}, {0.5, 0.0}), 0.17, 1e-12);
    EXPECT_NEAR(ground_steps_m(world, {0.5, 0.0}, {2.5, 0.0}), 0.0, 1e-12);
    EXPECT_NEAR(ground_steps_m(over_a_platform(), {0.0, 0.0}, {8.5, 0.3}), 0.0, 1e-9);
}

TEST(GroundWalls, OfAHoleFaceItsInside) {
    const std::vector<GroundWall> walls = ground_walls(hole());
    ASSERT_EQ(walls.size(), 4U);
    for (const GroundWall& wall : walls) {
        EXPECT_NEAR(wall.left_m.z(), -0.17, 1e-12);
        EXPECT_NEAR(wall.left_rise_m, 0.17, 1e-12);
        // Seen from the middle of the hole, the right end is clockwise of the left one.
        const Vector2d middle(1.5, 0.0);
        const Vector2d left = wall.left_m.head<2>() - middle;
        const Vector2d right = wall.right_m.head<2>() - middle;
        EXPECT_LT(left.x() * right.y() - left.y() * right.x(), 0.0);
    }
}

TEST(GroundWalls, BetweenTwoTreadsGoFromOneToTheOther) {
    const World world =
        world_of({level({1.0, -1.0}, {1.3, 1.0}, -0.17), level({1.3, -1.0}, {2.0, 1.0}, -0.34)});
    int between = 0;
    for (const GroundWall& wall : ground_walls(world)) {
        if (std::abs(wall.left_m.x() - 1.3) > 1e-9 || std::abs(wall.right_m.x() - 1.3) > 1e-9) continue;
        ++between;
        EXPECT_NEAR(wall.left_m.z(), -0.34, 1e-12);
        EXPECT_NEAR(wall.left_rise_m, 0.17, 1e-12);
        EXPECT_GT(wall.right_m.y() - wall.left_m.y(), -2.0 - 1e-9);
    }
    EXPECT_EQ(between, 1);
}

TEST(GroundWalls, AtTheSidesOfARampAreAsHighAsTheRamp) {
    double highest_m = 0.0;
    for (const GroundWall& wall : ground_walls(over_a_platform()))
        highest_m = std::max({highest_m, wall.left_rise_m, wall.right_rise_m});
    EXPECT_NEAR(highest_m, rise_m, 1e-9);
}

const Polygon footprint = RobotModel{}.footprint_m;  // x = -0.25 .. 0.25, y = -0.2 .. 0.2

TEST(Overhang, BeginsWhereTheOutlinePassesTheEdge) {
    EXPECT_FALSE(overhang(hole(), footprint, {0.74, 0.0, 0.0}));
    const auto edge = overhang(hole(), footprint, {0.76, 0.0, 0.0});
    ASSERT_TRUE(edge.has_value());
    EXPECT_NEAR(edge->depth_m, 0.17, 1e-12);
    EXPECT_NEAR(edge->at_m.x(), 1.01, 1e-9);
}

TEST(Overhang, IsFoundOnEverySideOfTheRobot) {
    EXPECT_TRUE(overhang(hole(), footprint, {2.24, 0.0, 0.0}));  // behind
    EXPECT_FALSE(overhang(hole(), footprint, {2.26, 0.0, 0.0}));
    EXPECT_TRUE(overhang(hole(), footprint, {1.5, -1.19, 0.0}));  // on the left
    EXPECT_FALSE(overhang(hole(), footprint, {1.5, -1.21, 0.0}));
    EXPECT_TRUE(overhang(hole(), footprint, {1.5, 1.19, 0.0}));        // on the right
    EXPECT_TRUE(overhang(hole(), footprint, {1.5, -1.24, M_PI / 2}));  // ahead, turned to the left
    EXPECT_FALSE(overhang(hole(), footprint, {1.5, -1.26, M_PI / 2}));
}

TEST(Overhang, OfACornerThatPassesACornerOfTheHoleCounts) {
    const Pose2 slanting{0.72, -1.28, M_PI / 4};
    const Vector2d tip = transform(slanting, Vector2d(0.25, 0.2));
    EXPECT_LT(tip.x(), 1.0);
    EXPECT_TRUE(overhang(hole(), footprint, {0.86, -1.10, M_PI / 4}));
    EXPECT_FALSE(overhang(hole(), footprint, slanting));
}

TEST(Overhang, StepsUpToThreeCentimetresAndRampsAreNoFall) {
    EXPECT_FALSE(overhang(world_of({level({1.0, -1.0}, {2.0, 1.0}, -0.029)}), footprint, {0.9, 0.0, 0.0}));
    EXPECT_TRUE(overhang(world_of({level({1.0, -1.0}, {2.0, 1.0}, -0.031)}), footprint, {0.9, 0.0, 0.0}));
    for (double x_m = 0.0; x_m < 10.0; x_m += 0.05)
        EXPECT_FALSE(overhang(over_a_platform(), footprint, {x_m, 0.0, 0.0})) << x_m;
    EXPECT_TRUE(overhang(over_a_platform(), footprint, {5.0, 1.9, 0.0}));  // over the side of the platform
}

double clearance_m(const World& world, const Pose2& pose) {
    return clearance(world, {}, pose, 0.0).distance_m;
}

TEST(GroundClearance, AKerbOfFiveCentimetresIsTouchedAndAThresholdOfTwoIsNot) {
    const World kerb = world_of({level({1.0, -1.0}, {2.0, 1.0}, 0.05)});
    EXPECT_NEAR(clearance_m(kerb, {0.5, 0.0, 0.0}), 0.25, 1e-9);
    EXPECT_LE(clearance_m(kerb, {0.76, 0.0, 0.0}), 0.0);
    EXPECT_EQ(clearance(kerb, {}, {0.5, 0.0, 0.0}, 0.0).nearest, "piece");
    const World threshold = world_of({level({1.0, -1.0}, {1.1, 1.0}, 0.02)});
    EXPECT_TRUE(std::isinf(clearance_m(threshold, {0.9, 0.0, 0.0})));
}

TEST(GroundClearance, EdgesThatLeadDownAndRampsAreNotTouched) {
    EXPECT_TRUE(std::isinf(clearance_m(hole(), {0.5, 0.0, 0.0})));
    const World world = over_a_platform();
    for (double x_m = 0.0; x_m < 10.0; x_m += 0.1)
        EXPECT_TRUE(std::isinf(clearance_m(world, {x_m, 0.0, 0.0}))) << x_m;
    EXPECT_NEAR(clearance_m(world, {5.0, 2.5, 0.0}), 0.3, 1e-6);  // beside the platform
}

TEST(GroundClearance, HeightsOfSolidsCountFromTheGroundOfTheRobot) {
    World world = world_of({level({-1.0, -2.0}, {3.0, 2.0}, 1.0)});
    Solid solid;
    solid.shape = Box{{0.2, 0.2, 0.5}};
    solid.T_world_solid.translation() << 1.0, 0.0, 1.25;
    world.solids = {solid};
    EXPECT_NEAR(clearance_m(world, {}), 0.65, 1e-9);
    world.solids[0].T_world_solid.translation().z() = 0.7;  // its top ends below the robot's ground
    EXPECT_TRUE(std::isinf(clearance_m(world, {})));
}

TEST(GroundLidar, SeesStepsThatReachThroughItsPlaneOnly) {
    LidarParams params;
    params.beams = 3;
    params.field_of_view_deg = 20.0;
    const auto ahead_m = [&](double height_m) {
        const World world = world_of({level({1.0, -1.0}, {2.0, 1.0}, height_m)});
        return scan(world, params, {}, 0.0).beams[1].range_m;
    };
    EXPECT_NEAR(ahead_m(0.5), 1.0, 1e-9);
    EXPECT_EQ(ahead_m(0.2), params.range_max_m);
    EXPECT_EQ(ahead_m(-0.5), params.range_max_m);
}

TEST(Ride, IsTheIdentityOnTheFloor) {
    EXPECT_TRUE(ride_on_ground({}, {1.0, 2.0, 0.5}).matrix().isIdentity(0.0));
    EXPECT_TRUE(ride_on_ground(hole(), {-1.0, 0.0, 0.5}).matrix().isIdentity(1e-12));
}

TEST(Ride, OnARampTheNoseRisesAndHeadingBackItSinks) {
    const World world = over_a_platform();
    const double slope = rise_m / 3.0;
    const Eigen::Isometry3d up = ride_on_ground(world, {2.5, 0.0, 0.0});
    EXPECT_NEAR(up.translation().z(), rise_m / 2, 1e-3);
    EXPECT_NEAR((up.linear() * Vector3d::UnitX()).z(), std::sin(std::atan(slope)), 1e-3);
    const Eigen::Isometry3d back = ride_on_ground(world, {2.5, 0.0, M_PI});
    EXPECT_NEAR((back.linear() * Vector3d::UnitX()).z(), -std::sin(std::atan(slope)), 1e-3);
}

TEST(Ride, AcrossARampTheUphillSideRises) {
    const World world = over_a_platform();
    // Uphill is +x; with the nose along -y, the left side points uphill.
    EXPECT_GT((ride_on_ground(world, {2.5, 0.0, -M_PI / 2}).linear() * Vector3d::UnitY()).z(), 0.09);
    EXPECT_LT((ride_on_ground(world, {2.5, 0.0, M_PI / 2}).linear() * Vector3d::UnitY()).z(), -0.09);
}

TEST(Ride, OverAThresholdIsABumpThatBeginsAndEndsSmoothly) {
    const World world = world_of({level({1.0, -1.0}, {1.1, 1.0}, 0.02)});
    double before_m = 0.0;
    double highest_m = 0.0;
    for (double x_m = 0.5; x_m < 1.6; x_m += 0.005) {
        const double z_m = ride_on_ground(world, {x_m, 0.0, 0.0}).translation().z();
        EXPECT_LT(std::abs(z_m - before_m), 0.008) << x_m;
        before_m = z_m;
        highest_m = std::max(highest_m, z_m);
    }
    EXPECT_NEAR(highest_m, 0.01, 0.001);  // two of four wheels are on it
    EXPECT_EQ(before_m, 0.0);
}

TEST(Ride, KeepsItsLevelWithAWheelOverAHole) {
    EXPECT_TRUE(ride_on_ground(hole(), {0.9, 0.0, 0.0}).matrix().isIdentity(1e-12));
}

View view_at(const World& world, const Pose2& pose) {
    CameraModel camera;
    camera.width_px = 320;
    camera.height_px = 240;
    camera.fx_px = camera.fy_px = 160.0;
    camera.cx_px = 159.5;
    camera.cy_px = 119.5;
    camera.mount.height_m = 0.6;
    camera.mount.pitch_rad = 20.0 * degree_rad;
    return on_ground(world, {camera, pose, 0.0});
}

/// Height of the surface on the ray to a point.
double seen_height_m(const World& world, const View& view, const Vector3d& point_m) {
    const auto pixel = project(view, point_m);
    return pixel ? look(world, view, *pixel)->point_m.z() : NAN;
}

TEST(GroundSight, ShowsTheBottomOfAHoleItsFarWallAndTheFloorBehindIt) {
    const World world = hole();
    const View view = view_at(world, {});
    EXPECT_NEAR(seen_height_m(world, view, {1.8, 0.1, -0.17}), -0.17, 1e-9);
    EXPECT_NEAR(seen_height_m(world, view, {2.0, 0.1, -0.08}), -0.08, 1e-9);
    EXPECT_NEAR(seen_height_m(world, view, {2.5, 0.1, 0.0}), 0.0, 1e-9);
    EXPECT_NEAR(seen_height_m(world, view, {0.95, 0.1, 0.0}), 0.0, 1e-9);
    // A ray just over the near edge meets the bottom.
    const auto over = look(world, view, *project(view, {1.02, 0.1, 0.0}));
    EXPECT_NEAR(over->point_m.z(), -0.17, 1e-9);
    EXPECT_NEAR(over->point_m.x(), 1.02 * 0.77 / 0.6, 1e-6);
}

TEST(GroundSight, FollowsTheTiltOfTheRobotOnARamp) {
    const World world = over_a_platform();
    const View level_view = view_at(world, {5.0, 0.0, 0.0});
    const View up = view_at(world, {2.5, 0.0, 0.0});
    EXPECT_NEAR(level_view.T_flat_robot.translation().z(), rise_m, 1e-9);
    // The plane of the ramp keeps its place in the image; the platform's far floor appears higher.
    const Vector2d middle(159.5, 150.0);
    const auto on_ramp = look(world, up, middle);
    ASSERT_TRUE(on_ramp.has_value());
    EXPECT_NEAR(on_ramp->depth_m, look({}, view_at({}, {}), middle)->depth_m, 2e-3);
    EXPECT_NEAR(on_ramp->point_m.z(), ground_height_m(world, on_ramp->point_m.head<2>()), 1e-9);
}

TEST(GroundFlow, OfARampIsThatOfTheFloorWhileTheRobotDrivesUp) {
    const World world = over_a_platform();
    const Vector2d pixel(200.0, 170.0);
    const double along = std::cos(std::atan(rise_m / 3.0));
    const auto ramp_flow =
        exact_flow(world, view_at(world, {2.0, 0.0, 0.0}), view_at(world, {2.1, 0.0, 0.0}), pixel);
    const auto floor_flow = exact_flow({}, view_at({}, {}), view_at({}, {0.1 / along, 0.0, 0.0}), pixel);
    ASSERT_TRUE(ramp_flow && floor_flow);
    EXPECT_LT((ramp_flow->flow_px - floor_flow->flow_px).norm(), 0.1);
}

TEST(GroundPassable, NeedsAWayAroundAHole) {
    World world = world_of({level({3.0, -2.0}, {4.0, 1.0}, -0.5)});
    world.goal = Vector2d(8.0, 0.0);
    for (const double y_m : {-2.05, 2.05}) {
        Solid wall;
        wall.shape = Box{{14.0, 0.1, 2.0}};
        wall.T_world_solid.translation() << 4.0, y_m, 1.0;
        world.solids.push_back(wall);
        wall.shape = Box{{0.1, 4.2, 2.0}};
        wall.T_world_solid.translation() << (y_m < 0.0 ? -1.5 : 10.0), 0.0, 1.0;
        world.solids.push_back(wall);
    }
    EXPECT_TRUE(passable(world, 0.40, 1.0));
    world.ground[0] = level({3.0, -2.0}, {4.0, 1.5}, -0.5);
    EXPECT_FALSE(passable(world, 0.40, 1.0));
    world.ground[0] = level({3.0, -2.0}, {4.0, 1.5}, -0.02);
    EXPECT_TRUE(passable(world, 0.40, 1.0));
}

}  // namespace
}  // namespace flownav::sim
