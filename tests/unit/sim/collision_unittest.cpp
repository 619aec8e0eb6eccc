#include "flownav/sim/collision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/sim/random.h"

namespace flownav::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Isometry3d at(double x_m, double y_m, double z_m) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translate(Vector3d(x_m, y_m, z_m));
    return pose;
}

World world_of(const Shape& shape, const Isometry3d& pose) {
    World world;
    Solid solid;
    solid.name = "thing";
    solid.shape = shape;
    solid.T_world_solid = pose;
    world.solids.push_back(solid);
    return world;
}

/// A robot 1 m long and 0.5 m wide; the axis is 0.3 m ahead of the rear.
RobotModel long_robot() {
    RobotModel robot;
    robot.footprint_m = {{0.7, 0.25}, {-0.3, 0.25}, {-0.3, -0.25}, {0.7, -0.25}};
    return robot;
}

/// A fork that is open at the front: 0.4 m deep, 0.4 m wide inside.
RobotModel fork_robot() {
    RobotModel robot;
    robot.footprint_m = {{0.5, 0.3},  {-0.2, 0.3}, {-0.2, -0.3}, {0.5, -0.3},
                         {0.5, -0.2}, {0.1, -0.2}, {0.1, 0.2},   {0.5, 0.2}};
    return robot;
}

double distance(const World& world, const RobotModel& robot, const Pose2& pose = {}) {
    return clearance(world, robot, pose, 0.0).distance_m;
}

TEST(Clearance, OfAnEmptyWorldIsInfinite) {
    const Clearance clear = clearance({}, {}, {}, 0.0);
    EXPECT_TRUE(std::isinf(clear.distance_m));
    EXPECT_EQ(clear.nearest, "");
}

TEST(Clearance, ToAPostAheadIsMeasuredFromTheFront) {
    EXPECT_NEAR(distance(world_of(Cylinder{0.1, 1.0}, at(2.0, 0.0, 0.5)), long_robot()), 2.0 - 0.7 - 0.1,
                1e-12);
}

TEST(Clearance, ToAPostBehindIsMeasuredFromTheRear) {
    EXPECT_NEAR(distance(world_of(Cylinder{0.1, 1.0}, at(-2.0, 0.0, 0.5)), long_robot()), 2.0 - 0.3 - 0.1,
                1e-12);
}

TEST(Clearance, ToAPostOnTheLeftShrinksWhenTheRobotTurnsItsNoseThere) {
    const World world = world_of(Cylinder{0.1, 1.0}, at(0.0, 2.0, 0.5));
    EXPECT_NEAR(distance(world, long_robot()), 2.0 - 0.25 - 0.1, 1e-12);
    EXPECT_NEAR(distance(world, long_robot(), {0.0, 0.0, M_PI / 2}), 2.0 - 0.7 - 0.1, 1e-12);
    EXPECT_NEAR(distance(world, long_robot(), {0.0, 0.0, -M_PI / 2}), 2.0 - 0.3 - 0.1, 1e-12);
}

TEST(Clearance, ToACornerIsTheSlantingDistance) {
    const World world = world_of(Box{{1.0, 1.0, 1.0}}, at(0.7 + 0.3 + 0.5, 0.25 + 0.4 + 0.5, 0.5));
    EXPECT_NEAR(distance(world, long_robot()), 0.5, 1e-12);
}

TEST(Clearance, ToAnEdgeAgainstACornerIsExact) {
    Isometry3d turned = at(2.0, 0.0, 0.5);
    turned.rotate(AngleAxisd(M_PI / 4, Vector3d::UnitZ()));
    EXPECT_NEAR(distance(world_of(Box{{1.0, 1.0, 1.0}}, turned), long_robot()), 1.3 - std::sqrt(0.5), 1e-12);
}

TEST(Clearance, IsNegativeInContact) {
    EXPECT_LT(distance(world_of(Cylinder{0.1, 1.0}, at(0.75, 0.0, 0.5)), long_robot()), 0.0);
    EXPECT_LT(distance(world_of(Box{{0.2, 0.2, 1.0}}, at(0.3, 0.0, 0.5)), long_robot()), 0.0);
    EXPECT_LT(distance(world_of(Box{{9.0, 9.0, 1.0}}, at(0.3, 0.0, 0.5)), long_robot()), 0.0);
}

TEST(Clearance, OutlinesThatCrossWithoutACornerInsideAreContact) {
    EXPECT_LE(distance(world_of(Box{{0.1, 4.0, 1.0}}, at(0.2, 0.0, 0.5)), long_robot()), 0.0);
}

TEST(Clearance, InsideANotchIsNoContact) {
    EXPECT_NEAR(distance(world_of(Cylinder{0.05, 1.0}, at(0.35, 0.0, 0.5)), fork_robot()), 0.15, 1e-12);
    EXPECT_NEAR(distance(world_of(Box{{0.1, 0.1, 1.0}}, at(0.4, 0.0, 0.5)), fork_robot()), 0.15, 1e-12);
    EXPECT_LT(distance(world_of(Cylinder{0.05, 1.0}, at(0.35, 0.17, 0.5)), fork_robot()), 0.0);
}

TEST(Clearance, ThingsBelowTheRobotOrAboveItDoNotCount) {
    EXPECT_TRUE(std::isinf(distance(world_of(Box{{1.0, 1.0, 0.02}}, at(0.0, 0.0, 0.01)), RobotModel{})));
    EXPECT_FALSE(std::isinf(distance(world_of(Box{{1.0, 1.0, 0.03}}, at(0.0, 0.0, 0.015)), RobotModel{})));
    RobotModel low;
    low.height_m = 0.5;
    const World table = world_of(Box{{1.0, 1.0, 0.04}}, at(0.0, 0.0, 0.72));
    EXPECT_TRUE(std::isinf(distance(table, low)));
    EXPECT_LT(distance(table, RobotModel{}), 0.0);
}

TEST(Clearance, OfASphereIsThatOfItsWidestSectionBelowTheRobotsTop) {
    RobotModel low;
    low.height_m = 0.5;
    const World ball = world_of(Sphere{0.5}, at(2.0, 0.0, 0.8));
    EXPECT_NEAR(distance(ball, low), 2.0 - 0.25 - 0.4, 1e-12);  // 0.5^2 = 0.3^2 + 0.4^2
    EXPECT_NEAR(distance(ball, RobotModel{}), 2.0 - 0.25 - 0.5, 1e-12);
}

TEST(Clearance, OfALeaningBoxIsExactUpToTheRobotsTop) {
    // A plank of 2 m leans away from the robot; only its part below 1 m counts.
    Isometry3d leaning = at(2.0, 0.0, 0.0);
    leaning.rotate(AngleAxisd(M_PI / 4, Vector3d::UnitY()));
    RobotModel robot;
    robot.height_m = 0.5;
    // The plank extends from (1.29, -0.71) to (2.71, 0.71) in x and z; heights below 0.02 m are ignored.
    const double surface_m = 0.05 / std::sqrt(0.5);  // half the thickness, measured along x
    EXPECT_NEAR(distance(world_of(Box{{0.1, 1.0, 2.0}}, leaning), robot), 2.0 + 0.02 - surface_m - 0.25,
                1e-9);
    leaning = at(2.0, 0.0, 0.0);
    leaning.rotate(AngleAxisd(-M_PI / 4, Vector3d::UnitY()));
    EXPECT_NEAR(distance(world_of(Box{{0.1, 1.0, 2.0}}, leaning), robot), 2.0 - 0.5 - surface_m - 0.25, 1e-9);
}

TEST(Clearance, OfALyingCylinderIsItsWidthToHalfAPercent) {
    Isometry3d lying = at(2.0, 0.0, 0.5);
    lying.rotate(AngleAxisd(M_PI / 2, Vector3d::UnitX()));
    const double found_m = distance(world_of(Cylinder{0.2, 3.0}, lying), RobotModel{});
    EXPECT_LE(found_m, 2.0 - 0.25 - 0.2 + 1e-9);
    EXPECT_GE(found_m, 2.0 - 0.25 - 0.2 * 1.006);
}

TEST(Clearance, IgnoresWhatIsNotSolid) {
    World world = world_of(Cylinder{0.1, 1.0}, at(0.0, 0.0, 0.5));
    world.solids[0].solid = false;
    EXPECT_TRUE(std::isinf(distance(world, RobotModel{})));
}

TEST(Clearance, FollowsAMover) {
    World world = world_of(Cylinder{0.1, 1.0}, at(9.0, 9.0, 0.5));
    world.solids[0].script = {{0.0, at(4.0, 0.0, 0.5)}, {2.0, at(0.0, 0.0, 0.5)}};
    EXPECT_NEAR(clearance(world, {}, {}, 1.0).distance_m, 2.0 - 0.25 - 0.1, 1e-12);
    EXPECT_LT(clearance(world, {}, {}, 2.0).distance_m, 0.0);
}

TEST(Clearance, NamesTheNearest) {
    World world = world_of(Cylinder{0.1, 1.0}, at(3.0, 0.0, 0.5));
    world.solids.push_back(world.solids[0]);
    world.solids[1].name = "nearer";
    world.solids[1].T_world_solid = at(0.0, 1.0, 0.5);
    EXPECT_EQ(clearance(world, {}, {}, 0.0).nearest, "nearer");
}

TEST(Clearance, ToManyThingsIsThatToTheNearestOfThem) {
    Random random(3);
    for (int run = 0; run < 50; ++run) {
        World world;
        double nearest_m = INFINITY;
        for (int i = 0; i < 20; ++i) {
            Isometry3d pose =
                at(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(0.0, 1.0));
            pose.rotate(AngleAxisd(random.uniform(-0.5, 0.5), Vector3d::UnitX()));
            const double size_m = random.uniform(0.05, 1.5);
            const Shape shape = i % 2 == 0 ? Shape(Box{{size_m, 0.1, 0.1}}) : Shape(Cylinder{0.1, size_m});
            const World alone = world_of(shape, pose);
            nearest_m = std::min(nearest_m, distance(alone, long_robot(), {1.0, 1.0, 0.5}));
            world.solids.push_back(alone.solids[0]);
        }
        EXPECT_EQ(distance(world, long_robot(), {1.0, 1.0, 0.5}), nearest_m) << run;
    }
}

/// Distance between two outlines by brute force, from sampled points on one to the other.
double sampled_distance(const Polygon& outline, const Polygon& other) {
    double distance_m = INFINITY;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        for (int k = 0; k < 400; ++k) {
            const Vector2d& next = outline[(i + 1) % outline.size()];
            distance_m =
                std::min(distance_m, signed_distance_m(other, outline[i] + (next - outline[i]) * k / 400.0));
        }
    }
    return distance_m;
}

TEST(Clearance, AgreesWithSampledOutlinesInRandomPlaces) {
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        const RobotModel robot = i % 2 == 0 ? fork_robot() : long_robot();
        const Vector3d size(random.uniform(0.1, 1.0), random.uniform(0.1, 1.0), 1.0);
        const Pose2 box{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-3.0, 3.0)};
        Isometry3d pose = at(box.x_m, box.y_m, 0.5);
        pose.rotate(AngleAxisd(box.yaw_rad, Vector3d::UnitZ()));
        Polygon corners;
        for (const auto& [x, y] : {std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1)})
            corners.push_back(transform(box, Vector2d(x * size.x() / 2, y * size.y() / 2)));
        const double sampled_m = std::min(sampled_distance(corners, robot.footprint_m),
                                          sampled_distance(robot.footprint_m, corners));
        const double found_m = distance(world_of(Box{size}, pose), robot);
        if (sampled_m > 0.01) {
            EXPECT_NEAR(found_m, sampled_m, 0.004) << i;
        } else if (sampled_m < -0.003) {
            EXPECT_LE(found_m, 0.0) << i;
        }
    }
}

}  // namespace
}  // namespace flownav::sim
