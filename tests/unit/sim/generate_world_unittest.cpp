#include "flownav/sim/generate_world.h"

#include <gtest/gtest.h>

#include <set>

#include "flownav/sim/collision.h"
#include "flownav/sim/lidar.h"
#include "flownav/sim/passable.h"
#include "flownav/sim/sdf_world.h"

namespace flownav::sim {
namespace {

class GeneratedWorld : public ::testing::TestWithParam<WorldKind> {};

TEST_P(GeneratedWorld, IsTheSameForTheSameSeedOnly) {
    EXPECT_EQ(to_sdf(generate_world(GetParam(), 3)), to_sdf(generate_world(GetParam(), 3)));
    EXPECT_NE(to_sdf(generate_world(GetParam(), 3)), to_sdf(generate_world(GetParam(), 4)));
}

TEST_P(GeneratedWorld, HasAWayWithRoomAndAStartThatLooksIntoTheOpen) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const World world = generate_world(GetParam(), seed);
        ASSERT_TRUE(world.goal.has_value()) << world.name;
        EXPECT_TRUE(passable(world, 0.45, 1.0)) << world.name;
        EXPECT_GT(clearance(world, RobotModel{}, world.start, 0.0).distance_m, 0.3) << world.name;
        const Eigen::Vector2d start(world.start.x_m, world.start.y_m);
        EXPECT_GT((*world.goal - start).norm(), 8.0) << world.name;
        EXPECT_LT((*world.goal - start).norm(), 15.0) << world.name;
        LidarParams ahead;
        ahead.field_of_view_deg = 20.0;
        ahead.beams = 21;
        for (const Beam& beam : scan(world, ahead, world.start, 0.0).beams)
            EXPECT_GT(beam.range_m, 1.0) << world.name;
    }
}

TEST_P(GeneratedWorld, IsTexturedAndEveryThingHasAName) {
    const World world = generate_world(GetParam(), 5);
    std::set<std::string> names;
    for (const Solid& solid : world.solids) {
        EXPECT_EQ(solid.look.surface, Surface::Patterned) << solid.name;
        EXPECT_TRUE(names.insert(solid.name).second) << solid.name;
    }
    EXPECT_NE(world.floor.surface, Surface::Plain);
    EXPECT_GE(world.solids.size() + world.ground.size(), 8U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, GeneratedWorld, ::testing::ValuesIn(all_world_kinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

World gate(double width_m) {
    World world;
    world.goal = Eigen::Vector2d(4.0, 0.0);
    for (const double side : {-1.0, 1.0}) {
        Solid wall;
        wall.shape = Box{{0.2, 10.0, 2.0}};
        wall.T_world_solid.translate(Eigen::Vector3d(2.0, side * (5.0 + width_m / 2), 1.0));
        world.solids.push_back(wall);
        Solid side_wall;
        side_wall.shape = Box{{8.0, 0.2, 2.0}};
        side_wall.T_world_solid.translate(Eigen::Vector3d(2.0, side * 4.0, 1.0));
        world.solids.push_back(side_wall);
        Solid end_wall = wall;
        end_wall.T_world_solid.translation() = Eigen::Vector3d(side < 0 ? -1.5 : 5.5, 0.0, 1.0);
        world.solids.push_back(end_wall);
    }
    return world;
}

TEST(Passable, TellsAGateThatIsWideEnoughFromOneThatIsNot) {
    EXPECT_TRUE(passable(gate(1.0), 0.45, 1.0));
    EXPECT_FALSE(passable(gate(0.85), 0.45, 1.0));
}

TEST(Passable, NeedsAGoalAndFreeEnds) {
    World world = gate(2.0);
    world.goal = Eigen::Vector2d(2.0, 4.0);
    EXPECT_FALSE(passable(world, 0.45, 1.0));
    world.goal.reset();
    EXPECT_FALSE(passable(world, 0.45, 1.0));
}

TEST(Passable, LeavesOutWhatHangsHigherThanTheRobot) {
    World world = gate(0.5);
    for (Solid& solid : world.solids) solid.T_world_solid.translation().z() = 2.5;
    EXPECT_TRUE(passable(world, 0.45, 1.0));
}

}  // namespace
}  // namespace flownav::sim
