#include "flownav/sim/world_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flownav/sim/collision.h"
#include "flownav/sim/generate_world.h"
#include "flownav/sim/ground.h"
#include "flownav/sim/passable.h"
#include "flownav/sim/sdf_world.h"
#include "flownav/sim/straight_scene.h"

namespace flownav::sim {
namespace {

World real(WorldKind kind, std::uint64_t seed) {
    World world = generate_world(kind, seed);
    set_objects(world, ObjectLook::Real, seed);
    return world;
}

int count(const World& world, const std::string& prefix) {
    return static_cast<int>(std::count_if(world.solids.begin(), world.solids.end(), [&](const Solid& solid) {
        return solid.name.rfind(prefix, 0) == 0;
    }));
}

class RealWorld : public ::testing::TestWithParam<WorldKind> {};

TEST_P(RealWorld, HasThingsOfOneGreyAndKeepsItsWayThrough) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const World world = real(GetParam(), seed);
        for (const Solid& solid : world.solids) {
            EXPECT_TRUE(solid.look.surface == Surface::Plain || solid.look.surface == Surface::Lamp)
                << solid.name;
            EXPECT_GE(solid.look.grey, 0.0) << solid.name;
            EXPECT_LE(solid.look.grey, 255.0) << solid.name;
        }
        EXPECT_TRUE(passable(world, 0.42, 1.0)) << world.name;
        EXPECT_GT(clearance(world, RobotModel{}, world.start, 0.0).distance_m, 0.25) << world.name;
    }
}

TEST_P(RealWorld, IsTheSameForTheSameSeedOnly) {
    EXPECT_EQ(to_sdf(real(GetParam(), 3)), to_sdf(real(GetParam(), 3)));
    World other = generate_world(GetParam(), 3);
    set_objects(other, ObjectLook::Real, 4);
    EXPECT_NE(to_sdf(real(GetParam(), 3)), to_sdf(other));
}

INSTANTIATE_TEST_SUITE_P(Kinds, RealWorld, ::testing::ValuesIn(all_world_kinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

TEST(WorldLook, AThirdOfTheWallsOfOfficesHaveSkirtingBoardsAndSomeHaveDoors) {
    int walls = 0;
    int boards = 0;
    int doors = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const World world = real(WorldKind::Office, seed);
        walls += count(world, "wall");
        boards += count(world, "skirting");
        doors += count(world, "door");
        EXPECT_GE(count(world, "tape"), 3);
        EXPECT_GE(count(world, "mat"), 1);
        EXPECT_GE(count(world, "lamp"), 4);
        EXPECT_TRUE(world.shadow_light.has_value());
    }
    EXPECT_NEAR(static_cast<double>(boards) / walls, 1.0 / 3.0, 0.07);
    EXPECT_GT(doors, walls / 8);
}

TEST(WorldLook, WhatLiesOnTheFloorIsDrivenOver) {
    const World world = real(WorldKind::Hall, 1);
    for (const Solid& solid : world.solids) {
        const bool lies = solid.name.rfind("tape", 0) == 0 || solid.name.rfind("paper", 0) == 0 ||
                          solid.name.rfind("mat", 0) == 0;
        EXPECT_EQ(solid.solid, !lies && solid.name.rfind("lamp", 0) != 0) << solid.name;
    }
}

TEST(WorldLook, NothingLiesOverAHoleOrOnARamp) {
    for (const WorldKind kind : {WorldKind::Stairs, WorldKind::Ramp}) {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const World world = real(kind, seed);
            EXPECT_GE(count(world, "tape") + count(world, "mat"), 1) << world.name;
            for (const Solid& solid : world.solids) {
                if (solid.name.rfind("mat", 0) != 0) continue;
                EXPECT_EQ(ground_height_m(world, solid.T_world_solid.translation().head<2>()), 0.0)
                    << world.name;
            }
        }
    }
}

TEST(WorldLook, ForestsHaveTheShadowsOfTheSunAndNoLamps) {
    const World world = real(WorldKind::Forest, 1);
    EXPECT_EQ(count(world, "lamp"), 0);
    ASSERT_TRUE(world.shadow_light.has_value());
    EXPECT_LT(world.shadow_light->soft_m, 0.05);
}

TEST(WorldLook, OtherLooksChangeTheSurfaceOfEverythingButLamps) {
    World world = real(WorldKind::Office, 1);
    const int lamps = count(world, "lamp");
    for (const auto& [look, surface] : {std::pair(ObjectLook::Patterned, Surface::Patterned),
                                        {ObjectLook::Faint, Surface::Faint},
                                        {ObjectLook::Plain, Surface::Plain}}) {
        set_objects(world, look, 1);
        int changed = 0;
        for (const Solid& solid : world.solids) changed += solid.look.surface == surface;
        EXPECT_EQ(changed + lamps, static_cast<int>(world.solids.size())) << to_string(look);
    }
}

TEST(GeneratedStairs, HaveADropOrAKerbThatTheWayGoesAround) {
    int drops = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const World world = generate_world(WorldKind::Stairs, seed);
        ASSERT_FALSE(world.ground.empty()) << world.name;
        double lowest_m = 0.0;
        for (const GroundPiece& piece : world.ground)
            lowest_m = std::min(lowest_m, piece.T_world_ground.translation().z());
        drops += lowest_m < -0.05;
        EXPECT_FALSE(overhang(world, RobotModel{}.footprint_m, world.start)) << world.name;
        EXPECT_EQ(ground_height_m(world, *world.goal), 0.0) << world.name;
    }
    EXPECT_GT(drops, 45);
}

TEST(GeneratedRamps, LeanByAtMostEightDegreesAndHaveNoStepBeyondThreeCentimetres) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const World world = generate_world(WorldKind::Ramp, seed);
        for (const GroundPiece& piece : world.ground)
            EXPECT_GT(piece.T_world_ground.linear()(2, 2), std::cos(8.01 * M_PI / 180.0)) << world.name;
        double highest_m = 0.0;
        for (double x_m = 0.0; x_m < world.goal->x(); x_m += 0.05) {
            highest_m = std::max(highest_m, ground_height_m(world, {x_m, 0.0}));
            EXPECT_FALSE(overhang(world, RobotModel{}.footprint_m, {x_m, 0.0, 0.0}))
                << world.name << ' ' << x_m;
            EXPECT_GT(clearance(world, RobotModel{}, {x_m, 0.0, 0.0}, 0.0).distance_m, 0.1) << world.name;
        }
        EXPECT_GT(highest_m, 0.07) << world.name;
    }
}

TEST(StraightScene, HasItsThingAtItsDistanceAndOnItsSide) {
    StraightScene scene;
    scene.distance_m = 3.0;
    const RobotModel robot;
    for (const AheadThing thing : {AheadThing::Post, AheadThing::Box, AheadThing::WallAcross}) {
        scene.thing = thing;
        EXPECT_NEAR(clearance(straight_scene(scene), robot, {}, 0.0).distance_m, 3.0 - 0.25, 1e-9);
    }
    scene.thing = AheadThing::DoorEdge;
    scene.offset_m = 0.3;
    const World left = straight_scene(scene);
    EXPECT_GT(clearance(left, robot, {3.0, 0.0, 0.0}, 0.0).distance_m, 0.05);
    EXPECT_LT(clearance(left, robot, {3.0, 0.4, 0.0}, 0.0).distance_m, 0.0);
    EXPECT_GT(clearance(left, robot, {3.0, -1.0, 0.0}, 0.0).distance_m, 1.0);
}

TEST(StraightScene, EndsItsFloorAtItsDistance) {
    StraightScene scene;
    scene.thing = AheadThing::StepDown;
    scene.distance_m = 2.0;
    const World world = straight_scene(scene);
    EXPECT_FALSE(overhang(world, RobotModel{}.footprint_m, {1.74, 0.0, 0.0}));
    EXPECT_TRUE(overhang(world, RobotModel{}.footprint_m, {1.76, 0.0, 0.0}));
    scene.thing = AheadThing::KerbUp;
    scene.height_m = 0.05;
    EXPECT_NEAR(clearance(straight_scene(scene), RobotModel{}, {}, 0.0).distance_m, 1.75, 1e-9);
}

TEST(StraightScene, HasMarksAndWallsWhenToldAndRefusesNegativeLengths) {
    StraightScene scene;
    scene.thing = AheadThing::None;
    EXPECT_TRUE(straight_scene(scene).solids.empty());
    scene.marks = true;
    scene.side_walls_m = 1.0;
    const World world = straight_scene(scene);
    EXPECT_EQ(world.solids.size(), 6U);
    EXPECT_NEAR(clearance(world, RobotModel{}, {}, 0.0).distance_m, 0.8, 1e-9);
    scene.distance_m = -1.0;
    EXPECT_THROW(straight_scene(scene), std::invalid_argument);
}

}  // namespace
}  // namespace flownav::sim
