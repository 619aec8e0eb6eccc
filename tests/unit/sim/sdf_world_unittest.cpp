#include "flownav/sim/sdf_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

#include "flownav/sim/generate_world.h"
#include "flownav/sim/world_look.h"

namespace flownav::sim {
namespace {

namespace fs = std::filesystem;

fs::path file_with(const std::string& name, const std::string& text) {
    fs::path file = fs::path(::testing::TempDir()) / ("sdf_world_" + name + ".world");
    std::ofstream(file) << text;
    return file;
}

std::string sdf(const std::string& body) {
    return "<?xml version=\"1.0\"?>\n<sdf version=\"1.6\">\n<world name=\"w\">\n" + body +
           "</world>\n</sdf>\n";
}

LoadedWorld load(const std::string& name, const std::string& body) {
    return read_sdf_world(file_with(name, sdf(body)));
}

std::string complaint(const fs::path& file) {
    try {
        read_sdf_world(file);
    } catch (const WorldError& error) {
        return error.what();
    }
    return "";
}

constexpr auto post = "<geometry><cylinder><radius>0.075</radius><length>1</length></cylinder></geometry>";

std::string post_model(const std::string& name, const std::string& pose) {
    return "<model name=\"" + name + "\"><static>1</static><pose>" + pose +
           "</pose><link name=\"link\"><collision name=\"c\">" + post + "</collision><visual name=\"v\">" +
           post +
           "<material><script><uri>file://media</uri><name>Gazebo/Grey</name></script></material></visual></"
           "link></model>\n";
}

TEST(SdfWorld, AModelWithCollisionAndVisualIsOneSolid) {
    const LoadedWorld loaded = load("one", post_model("post", "1 2 0.5 0 0 0.3"));
    ASSERT_EQ(loaded.world.solids.size(), 1U);
    const Solid& solid = loaded.world.solids[0];
    EXPECT_EQ(solid.name, "post");
    EXPECT_TRUE(solid.visible);
    EXPECT_TRUE(solid.solid);
    EXPECT_EQ(std::get<Cylinder>(solid.shape).radius_m, 0.075);
    EXPECT_EQ(std::get<Cylinder>(solid.shape).length_m, 1.0);
    EXPECT_TRUE(solid.T_world_solid.translation().isApprox(Eigen::Vector3d(1.0, 2.0, 0.5)));
    EXPECT_EQ(solid.look.surface, Surface::Patterned);
    EXPECT_TRUE(loaded.warnings.empty());
}

TEST(SdfWorld, TheStateOfAWorldAddsNothing) {
    const LoadedWorld loaded = load(
        "state",
        post_model("post", "1 2 0.5 0 0 0") +
            "<state world_name='w'><model name='post'><pose frame=''>1 2 0.5 0 0 0</pose><scale>1 1 1</scale>"
            "<link name='link'><pose frame=''>1 2 0.5 0 0 0</pose></link></model></state>\n");
    EXPECT_EQ(loaded.world.solids.size(), 1U);
}

TEST(SdfWorld, PosesOfModelLinkAndPartAddUp) {
    const LoadedWorld loaded = load(
        "poses",
        "<model name='m'><pose>1 0 0 0 0 1.5707963267948966</pose><link name='l'><pose>1 0 0 0 0 0</pose>"
        "<collision name='c'><pose>0 2 0.5 0 0 0</pose><geometry><box><size>1 2 3</size></box></geometry>"
        "</collision></link></model>");
    ASSERT_EQ(loaded.world.solids.size(), 1U);
    const Solid& solid = loaded.world.solids[0];
    EXPECT_NEAR((solid.T_world_solid.translation() - Eigen::Vector3d(-1.0, 1.0, 0.5)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(solid.T_world_solid.linear()(1, 0), 1.0, 1e-12);
    EXPECT_EQ(std::get<Box>(solid.shape).size_m, Eigen::Vector3d(1.0, 2.0, 3.0));
    EXPECT_TRUE(solid.solid);
    EXPECT_FALSE(solid.visible);
}

TEST(SdfWorld, APartThatIsOnlySeenIsNotSolid) {
    const LoadedWorld loaded = load("seen",
                                    "<model name='m'><link name='l'><visual name='v'><geometry><sphere>"
                                    "<radius>0.3</radius></sphere></geometry></visual></link></model>");
    ASSERT_EQ(loaded.world.solids.size(), 1U);
    EXPECT_FALSE(loaded.world.solids[0].solid);
    EXPECT_TRUE(loaded.world.solids[0].visible);
    EXPECT_EQ(std::get<Sphere>(loaded.world.solids[0].shape).radius_m, 0.3);
}

TEST(SdfWorld, FramesSayStartAndGoal) {
    const LoadedWorld loaded = load("frames",
                                    "<frame name='start'><pose>1 2 0 0 0 0.5</pose></frame>"
                                    "<frame name='goal'><pose>7 8 0 0 0 0</pose></frame>");
    EXPECT_NEAR(loaded.world.start.x_m, 1.0, 1e-12);
    EXPECT_NEAR(loaded.world.start.y_m, 2.0, 1e-12);
    EXPECT_NEAR(loaded.world.start.yaw_rad, 0.5, 1e-12);
    ASSERT_TRUE(loaded.world.goal.has_value());
    EXPECT_NEAR((*loaded.world.goal - Eigen::Vector2d(7.0, 8.0)).norm(), 0.0, 1e-12);
    EXPECT_FALSE(load("no_frames", "").world.goal.has_value());
}

std::string ground(const std::string& material, const std::string& pose = "0 0 0 0 0 0") {
    return "<model name='ground'><pose>" + pose +
           "</pose><link name='l'><visual name='v'><geometry><plane><normal>0 0 1</normal><size>9 "
           "9</size></plane>"
           "</geometry><material><script><uri>x</uri><name>" +
           material + "</name></script></material></visual></link></model>";
}

TEST(SdfWorld, TheGroundPlaneIsTheFloorWithItsLook) {
    const World world = load("floor", ground("flownav/Tiles 90 7")).world;
    EXPECT_TRUE(world.solids.empty());
    EXPECT_EQ(world.floor.surface, Surface::Tiles);
    EXPECT_EQ(world.floor.grey, 90.0);
    EXPECT_EQ(world.floor.seed, 7U);
    EXPECT_EQ(load("grey_floor", ground("Gazebo/Grey")).world.floor.surface, Surface::Carpet);
}

TEST(SdfWorld, OtherPlanesMeshesAndIncludesAreLeftOutWithAWarning) {
    const LoadedWorld loaded =
        load("left_out",
             ground("Gazebo/Grey", "0 0 1 0 0.6 0") + "<include><uri>model://sun</uri></include>" +
                 "<model name='m'><link name='l'><collision name='c'><geometry><mesh><uri>a.dae</uri></mesh>"
                 "</geometry></collision></link></model>" +
                 post_model("post", "0 0 0 0 0 0"));
    EXPECT_EQ(loaded.world.solids.size(), 1U);
    ASSERT_EQ(loaded.warnings.size(), 3U);
    for (const std::string& warning : loaded.warnings)
        EXPECT_NE(warning.find("left_out.world: "), std::string::npos);
    EXPECT_NE(loaded.warnings[0].find("model://sun"), std::string::npos) << loaded.warnings[0];
}

TEST(SdfWorld, PlanesAtOtherHeightsAndBoxesOfGroundArePiecesOfGround) {
    const World world =
        load("ground",
             "<model name='step'><pose>2 1 -0.17 0 0 0.5</pose><link name='l'><collision name='c'>"
             "<geometry><plane><normal>0 0 1</normal><size>0.3 2</size></plane></geometry></collision>"
             "<visual name='v'><geometry><plane><normal>0 0 1</normal><size>0.3 2</size></plane>"
             "</geometry><material><script><uri>x</uri><name>flownav/Tiles 90 7</name></script>"
             "</material></visual></link></model>"
             "<model name='ground_ramp'><pose>5 0 0.1 0 -0.1 0</pose><link name='l'><collision name='c'>"
             "<geometry><box><size>2 1 0.4</size></box></geometry></collision></link></model>" +
                 post_model("post", "0 0 0.5 0 0 0"))
            .world;
    EXPECT_EQ(world.solids.size(), 1U);
    ASSERT_EQ(world.ground.size(), 2U);
    EXPECT_EQ(world.ground[0].name, "step");
    EXPECT_EQ(world.ground[0].look.surface, Surface::Tiles);
    EXPECT_EQ(world.ground[0].size_m, Eigen::Vector2d(0.3, 2.0));
    EXPECT_NEAR(world.ground[0].T_world_ground.translation().z(), -0.17, 1e-12);
    EXPECT_EQ(world.ground[1].size_m, Eigen::Vector2d(2.0, 1.0));
    // Its top is half of its height above its middle, along its normal.
    EXPECT_NEAR(world.ground[1].T_world_ground.translation().z(), 0.1 + 0.2 * std::cos(0.1), 1e-12);
    EXPECT_LT(world.ground[1].T_world_ground.linear()(0, 2), 0.0);
}

TEST(SdfWorld, BoxesOfGroundThatLeanTooFarStaySolids) {
    const LoadedWorld loaded =
        load("steep",
             "<model name='ground_wall'><pose>5 0 0.1 0 0.5 0</pose><link name='l'><collision name='c'>"
             "<geometry><box><size>2 1 0.4</size></box></geometry></collision></link></model>");
    EXPECT_EQ(loaded.world.solids.size(), 1U);
    EXPECT_TRUE(loaded.world.ground.empty());
}

TEST(SdfWorld, GroundLampsAndShadowsAreWrittenAndReadAgain) {
    for (const WorldKind kind : {WorldKind::Stairs, WorldKind::Ramp}) {
        World world = generate_world(kind, 2);
        furnish_as_real(world, 2);
        const World read = read_sdf_world(file_with("real", to_sdf(world))).world;
        EXPECT_EQ(to_sdf(read_sdf_world(file_with("real2", to_sdf(read))).world), to_sdf(read));
        ASSERT_EQ(read.ground.size(), world.ground.size());
        for (std::size_t i = 0; i < read.ground.size(); ++i) {
            EXPECT_EQ(read.ground[i].name, world.ground[i].name);
            EXPECT_TRUE(read.ground[i].T_world_ground.isApprox(world.ground[i].T_world_ground, 1e-8));
        }
        ASSERT_TRUE(read.shadow_light.has_value());
        EXPECT_NEAR((read.shadow_light->towards - world.shadow_light->towards).norm(), 0.0, 1e-8);
        EXPECT_NEAR(read.shadow_light->soft_m, world.shadow_light->soft_m, 1e-8);
        EXPECT_EQ(read.solids.size(), world.solids.size());
    }
}

TEST(SdfWorld, ShadowsThatGoWrongAreNamed) {
    for (const char* wrong : {"0 0 1 0.5", "0 0 -1 0.5 0.1", "0 0 1 1.5 0.1", "0 0 1 0.5 0.1 7", "a"}) {
        const std::string error = complaint(
            file_with("shadows", sdf("<flownav:shadows>" + std::string(wrong) + "</flownav:shadows>")));
        EXPECT_NE(error.find(wrong), std::string::npos) << error;
    }
}

std::string walker(const std::string& script) {
    return std::string(
               "<actor name='walker'><pose>5 5 0 0 0 0</pose><link name='l'><pose>0 0 0.5 0 0 0</pose>"
               "<collision name='c'>") +
           post + "</collision><visual name='v'>" + post + "</visual></link><script>" + script +
           "</script></actor>";
}

constexpr auto two_points =
    "<trajectory id='0' type='walk'><waypoint><time>1</time><pose>0 0 0 0 0 0</pose></waypoint>"
    "<waypoint><time>3</time><pose>0 4 0 0 0 0</pose></waypoint></trajectory>";

TEST(SdfWorld, AnActorMovesAlongItsTrajectory) {
    const World world = load("actor", walker(std::string("<loop>false</loop>") + two_points)).world;
    ASSERT_EQ(world.solids.size(), 1U);
    const auto y_at = [&](double time_s) { return pose_at(world.solids[0], time_s).translation().y(); };
    EXPECT_EQ(y_at(0.0), 0.0);
    EXPECT_NEAR(y_at(2.5), 3.0, 1e-12);
    EXPECT_EQ(y_at(99.0), 4.0);
    EXPECT_EQ(pose_at(world.solids[0], 2.0).translation().z(), 0.5);
}

TEST(SdfWorld, AnActorWaitsForItsDelayAndStartsOver) {
    const World world =
        load("loop", walker(std::string("<loop>true</loop><delay_start>10</delay_start>") + two_points))
            .world;
    const auto y_at = [&](double time_s) { return pose_at(world.solids[0], time_s).translation().y(); };
    EXPECT_EQ(y_at(10.5), 0.0);
    EXPECT_NEAR(y_at(12.0), 2.0, 1e-12);
    EXPECT_NEAR(y_at(15.0), 2.0, 1e-12);
    EXPECT_NEAR(y_at(599.0), y_at(11.0 + std::fmod(588.0, 3.0)), 1e-9);
}

TEST(SdfWorld, AnActorThatIsOnlySkinIsAPerson) {
    const World world =
        load("skin", "<actor name='p'><skin><filename>walk.dae</filename></skin><script><loop>false</loop>" +
                         std::string(two_points) + "</script></actor>")
            .world;
    ASSERT_EQ(world.solids.size(), 1U);
    EXPECT_EQ(world.solids[0].name, "p");
    EXPECT_GT(std::get<Cylinder>(world.solids[0].shape).length_m, 1.5);
}

TEST(SdfWorld, ErrorsNameFileAndLine) {
    EXPECT_NE(complaint("/no/such.world").find("/no/such.world: no such file"), std::string::npos);
    EXPECT_NE(complaint(::testing::TempDir()).find("is not a file"), std::string::npos);
    EXPECT_NE(
        complaint(
            file_with("xml", "<?xml version='1.0'?>\n<sdf version='1.6'>\n<world name='w'>\n</wolrd></sdf>"))
            .find("xml.world:3: "),
        std::string::npos);
    EXPECT_NE(complaint(file_with("text", "hello")).find("text.world"), std::string::npos);
    EXPECT_NE(complaint(file_with("empty", "")).find("empty.world"), std::string::npos);
    EXPECT_NE(
        complaint(file_with("no_world", "<sdf version='1.6'><model name='m'><link name='l'/></model></sdf>"))
            .find("holds no world"),
        std::string::npos);
    EXPECT_NE(
        complaint(file_with("size", sdf("<model name='m'><link name='l'><collision name='c'><geometry>\n<box>"
                                        "<size>1 2</size></box></geometry></collision></link></model>")))
            .find("size.world:5: "),
        std::string::npos);
}

TEST(SdfWorld, RefusesShapesWithoutSizeAndLooksThatGoWrong) {
    EXPECT_NE(complaint(file_with("radius",
                                  sdf("<model name='m'><link name='l'><collision name='c'><geometry><sphere>"
                                      "<radius>-1</radius></sphere></geometry></collision></link></model>")))
                  .find("must be > 0 m"),
              std::string::npos);
    for (const char* wrong :
         {"flownav/Wool 100 1", "flownav/Carpet 300 1", "flownav/Carpet 100", "flownav/Carpet 100 1 2"})
        EXPECT_NE(complaint(file_with("look", sdf(ground(wrong)))).find(wrong), std::string::npos) << wrong;
}

TEST(SdfWorld, KeepsTheConsoleQuiet) {
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    complaint(file_with(
        "noise", "<sdf version='1.6'><world name='w'><include><uri>model://x</uri></include><a/></worl>"));
    load("quiet", "<include><uri>model://x</uri></include><unknown/>");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST(SdfWorld, WhatIsWrittenIsReadAsTheSameWorld) {
    World world = generate_world(WorldKind::Forest, 2);
    world.solids[0].name = "a <b> & \"c\"";
    world.solids[1].visible = false;
    world.solids[2].solid = false;
    world.solids[3].script = {{0.5, world.solids[3].T_world_solid}, {2.0, world.solids[4].T_world_solid}};
    const World read = read_sdf_world(file_with("again", to_sdf(world))).world;
    ASSERT_EQ(read.solids.size(), world.solids.size());
    EXPECT_EQ(read.solids[0].name, world.solids[0].name);
    EXPECT_EQ(read.name, world.name);
    EXPECT_EQ(to_sdf(read_sdf_world(file_with("thrice", to_sdf(read))).world), to_sdf(read));
    EXPECT_NEAR(read.start.yaw_rad, world.start.yaw_rad, 1e-9);
    EXPECT_EQ(read.floor.seed, world.floor.seed);
    // Solids with a script come last, as actors.
    EXPECT_EQ(read.solids.back().name, world.solids[3].name);
    for (const double time_s : {0.0, 1.0, 5.0})
        EXPECT_TRUE(pose_at(read.solids.back(), time_s).isApprox(pose_at(world.solids[3], time_s), 1e-8));
    EXPECT_FALSE(read.solids[1].visible);
    EXPECT_FALSE(read.solids[2].solid);
    EXPECT_EQ(read.solids[2].look.seed, world.solids[2].look.seed);
}

TEST(SdfWorld, EverySurfaceIsWrittenAndReadAgain) {
    for (int number = 0; number <= static_cast<int>(Surface::Lamp); ++number) {
        World world;
        world.floor = {static_cast<Surface>(number), 90.0, 7};
        EXPECT_EQ(static_cast<int>(read_sdf_world(file_with("floor", to_sdf(world))).world.floor.surface),
                  number);
    }
}

TEST(SdfWorld, HundredsOfModelsAreReadQuickly) {
    std::string body;
    for (int i = 0; i < 365; ++i)
        body += post_model("post_" + std::to_string(i), std::to_string(0.2 * i) + " 0 0 0 0 0");
    const fs::path file = file_with("many", sdf(body));
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(read_sdf_world(file).world.solids.size(), 365U);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(took.count(), 10.0);  // 0.3 s typically; the limit allows for sanitizers and machine load
}

std::vector<fs::path> own_worlds() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(FLOWNAV_WORLDS)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

class OwnWorld : public ::testing::TestWithParam<fs::path> {};

TEST_P(OwnWorld, IsReadWithoutAWarning) {
    const LoadedWorld loaded = read_sdf_world(GetParam());
    EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.front();
    EXPECT_GE(loaded.world.solids.size(), 5U);
    EXPECT_EQ(loaded.world.name.substr(0, 4), GetParam().stem().string().substr(0, 4));
}

INSTANTIATE_TEST_SUITE_P(ShareWorlds, OwnWorld, ::testing::ValuesIn(own_worlds()),
                         [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace flownav::sim
