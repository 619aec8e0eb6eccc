#include "sim_app.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app_runs.h"
#include "flownav/cli/exit_status.h"
#include "flownav/core/version.h"
#include "flownav/flow/kernel.h"
#include "flownav/io/field_source.h"
#include "flownav/math/units.h"
#include "flownav/replay/replay.h"
#include "flownav/sim/generate_world.h"
#include "flownav/sim/sdf_world.h"
#include "flownav/sim/world_look.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;
using testing::Outcome;

Outcome run(const std::vector<std::string>& arguments) {
    return testing::run_app(run_sim_app, "flownav-sim", arguments);
}

fs::path test_folder() {
    return testing::folder_of_test("flownav_sim_app");
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Writes a world with a ball 1 m to the left of the origin.
std::string small_world() {
    const fs::path file = fs::path(::testing::TempDir()) / "flownav_sim_app" / "small.world";
    if (fs::exists(file)) return file.string();
    // Tests run in parallel: each writes a draft and renames it.
    const fs::path draft = testing::folder_of_test("flownav_sim_app_draft") / "small.world";
    fs::create_directories(file.parent_path());
    std::ofstream(draft)
        << "<sdf version='1.9'><world name='w'><model name='ball'><pose>0 1 0.5 0 0 0</pose>"
           "<link name='l'><collision name='c'><geometry><sphere><radius>0.2</radius></sphere>"
           "</geometry></collision></link></model></world></sdf>";
    fs::rename(draft, file);
    return file.string();
}

/// Arguments of a short drive with small images.
std::vector<std::string> small_drive(const fs::path& output) {
    return {small_world(), "--script", "forward 0.4", "--width",       "160",
            "--height",    "120",      "--output",    output.string(), "--quiet"};
}

TEST(SimApp, HelpAndVersionGoToTheOutputWithStatusZero) {
    const Outcome help = run({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_TRUE(help.error.empty());
    for (const char* part : {"--script", "--path", "--generate", "Exit status", "--interlaced"})
        EXPECT_NE(help.out.find(part), std::string::npos) << part;
    EXPECT_EQ(run({"--version"}).out, "flownav-sim " + std::string(version()) +
                                          "\nmatching kernel: " + flow::default_kernel().name + "\n");
}

TEST(SimApp, BadUsageIsStatusOneAndSaysWhatIsWrong) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{}, "one world"},
        {{"a.world", "b.world", "--script", "wait 1", "--output", "o"}, "one world"},
        {{"a.world", "--generate", "hall", "--script", "wait 1", "--output", "o"}, "one world"},
        {{"a.world"}, "--write-world"},
        {{"a.world", "--script", "wait 1"}, "--output"},
        {{"a.world", "--output", "o"}, "--path"},
        {{"a.world", "--script", "wait 1", "--path", "p.csv", "--output", "o"}, "not both"},
        {{"--generate", "cave", "--write-world", "o"}, "corridor, office, hall, forest, stairs, ramp"},
        {{"--generate", "hall", "--fov-deg", "190", "--write-world", "o"}, "--fov-deg 190: must be 10..140"},
        {{"--generate", "hall", "--width", "3", "--write-world", "o"}, "--width 3"},
        {{"--generate", "hall", "--height-m", "99", "--write-world", "o"}, "camera.height_m"},
        {{"--generate", "hall", "--script", "jump 1", "--output", "o"}, "\"jump 1\""},
        {{"--generate", "hall", "--unknown"}, "no option --unknown"},
    };
    for (const auto& [arguments, wrong] : cases) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 1) << wrong;
        EXPECT_TRUE(outcome.out.empty()) << outcome.out;
        EXPECT_NE(outcome.error.find(wrong), std::string::npos) << wrong << " in: " << outcome.error;
    }
    EXPECT_FALSE(fs::exists("o"));
}

TEST(SimApp, AWorldOrPathThatCannotBeReadIsStatusTwo) {
    const fs::path folder = test_folder();
    const std::string output = (folder / "o.rawlog").string();
    EXPECT_EQ(run({"/no/such.world", "--script", "wait 1", "--output", output}).status, 2);
    EXPECT_EQ(run({"--generate", "hall", "--path", "/no/such.csv", "--output", output}).status, 2);
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST(SimApp, WritesTheGeneratedWorld) {
    const fs::path file = test_folder() / "w.world";
    const Outcome outcome = run(
        {"--generate", "office", "--seed", "3", "--objects", "patterned", "--write-world", file.string()});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(text_of(file), sim::to_sdf(sim::generate_world(sim::WorldKind::Office, 3)));
    EXPECT_EQ(run({"--generate", "hall", "--write-world", "/no/such/folder/w.world"}).status, 3);
}

TEST(SimApp, GeneratedWorldsLookLikeRealRoomsUnlessToldOtherwise) {
    const fs::path file = test_folder() / "w.world";
    const auto written = [&](const std::vector<std::string>& looks) {
        std::vector<std::string> arguments = {"--generate", "office",        "--seed",
                                              "3",          "--write-world", file.string()};
        arguments.insert(arguments.end(), looks.begin(), looks.end());
        EXPECT_EQ(run(arguments).status, 0);
        return text_of(file);
    };
    sim::World real = sim::generate_world(sim::WorldKind::Office, 3);
    sim::furnish_as_real(real, 3);
    EXPECT_EQ(written({}), sim::to_sdf(real));
    EXPECT_EQ(written({"--objects", "real"}), sim::to_sdf(real));
    real.floor.surface = sim::Surface::Lino;
    EXPECT_EQ(written({"--floor", "lino"}), sim::to_sdf(real));
    EXPECT_EQ(written({"--objects", "plain"}).find("Patterned"), std::string::npos);
    EXPECT_NE(run({"--generate", "office", "--objects", "shiny", "--write-world", "o"})
                  .error.find("real, patterned"),
              std::string::npos);
}

struct Recorded {
    std::vector<double> times_s;
    std::vector<Field> fields;
    std::vector<io::PoseSample> odometry, truth;
};

Recorded read(const fs::path& file) {
    Recorded recorded;
    io::RawlogReader reader(file.string());
    io::FieldSource source(reader, config::CameraConfig{});
    while (auto event = source.next()) {
        if (auto* field = std::get_if<Field>(&*event)) {
            recorded.times_s.push_back(field->timestamp_s);
            recorded.fields.push_back(std::move(*field));
        } else {
            const auto& pose = std::get<io::PoseSample>(*event);
            (pose.source == io::PoseSample::Source::Odometry ? recorded.odometry : recorded.truth)
                .push_back(pose);
        }
    }
    return recorded;
}

TEST(SimApp, RecordsImagesOdometryAndTruthOfADrive) {
    const fs::path file = test_folder() / "drive.rawlog";
    const Outcome outcome = run(small_drive(file));
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const Recorded recorded = read(file);
    ASSERT_GT(recorded.fields.size(), 30U);
    EXPECT_EQ(recorded.odometry.size(), recorded.fields.size());
    EXPECT_EQ(recorded.truth.size(), recorded.fields.size());
    EXPECT_NEAR(recorded.times_s[10] - recorded.times_s[0], 0.4, 1e-6);
    const CameraModel& camera = recorded.fields[0].camera;
    EXPECT_EQ(camera.width_px, 160);
    EXPECT_NEAR(camera.fx_px, 80.0 / std::tan(27.5 * degree_rad), 1e-6);
    EXPECT_NEAR(camera.mount.height_m, 0.9, 1e-9);
    EXPECT_NEAR(camera.mount.pitch_rad, 25.0 * degree_rad, 1e-9);
    const auto& first = recorded.truth.front().pose;
    const auto& last = recorded.truth.back().pose;
    EXPECT_NEAR(std::hypot(last.x - first.x, last.y - first.y), 0.4, 2e-3);
    EXPECT_FALSE(fs::exists(file.string() + ".part"));
}

TEST(SimApp, AReplayOfTheRecordingComesNearTheTruth) {
    const fs::path folder = test_folder();
    const std::string railing = std::string(FLOWNAV_WORLDS) + "/railing_and_chair.world";
    const fs::path drive = folder / "drive.rawlog";
    ASSERT_EQ(run({railing, "--script", "forward 0.7; right 15 2; left 15 2", "--width", "320", "--height",
                   "240", "--output", drive.string(), "--quiet"})
                  .status,
              0);
    replay::ReplayOptions options;
    options.input = drive;
    options.output = folder / "result";
    ASSERT_EQ(replay::replay(options).status, cli::ExitStatus::Fine);
    const auto errors = nlohmann::json::parse(text_of(folder / "result" / "summary.json"))["errors"];
    const auto& truth = errors["ground_truth"];
    EXPECT_LT(truth["omega_cycle_rms_degps"].get<double>(), 0.12);
    EXPECT_LT(std::abs(truth["v_bias_percent"].get<double>()), 1.0);
    EXPECT_LT(truth["end_position_percent"].get<double>(), 1.0);
    EXPECT_LT(std::abs(truth["heading_end_deg"].get<double>()), 0.5);
    EXPECT_EQ(truth["t_measured_percent"].get<double>(), 100.0);
    // The wheel odometry overestimates the distance by 0.6 %.
    EXPECT_NEAR(errors["odometry"]["v_bias_percent"].get<double>() - truth["v_bias_percent"].get<double>(),
                -0.6, 0.4);
}

TEST(SimApp, TheSameSeedGivesTheSameBytes) {
    const fs::path folder = test_folder();
    auto other = small_drive(folder / "other.rawlog");
    other.insert(other.end(), {"--seed", "2"});
    ASSERT_EQ(run(small_drive(folder / "a.rawlog")).status, 0);
    ASSERT_EQ(run(small_drive(folder / "b.rawlog")).status, 0);
    ASSERT_EQ(run(other).status, 0);
    EXPECT_EQ(text_of(folder / "a.rawlog"), text_of(folder / "b.rawlog"));
    EXPECT_NE(text_of(folder / "a.rawlog"), text_of(folder / "other.rawlog"));
}

TEST(SimApp, RecordsFieldsOfAnInterlacedCamera) {
    const fs::path file = test_folder() / "fields.rawlog";
    auto arguments = small_drive(file);
    arguments.emplace_back("--interlaced");
    ASSERT_EQ(run(arguments).status, 0);
    const Recorded recorded = read(file);
    ASSERT_GT(recorded.fields.size(), 60U);
    EXPECT_EQ(recorded.fields[0].image.height_px, 60);
    EXPECT_NEAR(recorded.fields[0].camera.fx_px, 2.0 * recorded.fields[0].camera.fy_px, 1e-6);
    EXPECT_NEAR(recorded.times_s[1] - recorded.times_s[0], 0.02, 1e-6);
    EXPECT_NEAR(std::abs(recorded.fields[1].camera.cy_px - recorded.fields[0].camera.cy_px), 0.5, 1e-6);
}

TEST(SimApp, WarnsWhenThePathGoesThroughSomething) {
    const fs::path folder = test_folder();
    std::ofstream(folder / "way.csv") << "x_m,y_m,yaw_rad\n0,0.5,0\n0,1.0,0\n";
    const Outcome outcome =
        run({small_world(), "--path", (folder / "way.csv").string(), "--speed", "0.5", "--width", "64",
             "--height", "48", "--output", (folder / "d.rawlog").string(), "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.error.find("goes through ball"), std::string::npos) << outcome.error;
}

TEST(SimApp, WarnsWhenThePathGoesOverAnEdge) {
    const fs::path folder = test_folder();
    std::ofstream(folder / "edge.world")
        << "<sdf version='1.9'><world name='edge'><model name='pit'><pose>1 0 -0.5 0 0 0</pose><link "
           "name='l'>"
           "<collision name='c'><geometry><plane><normal>0 0 1</normal><size>1 1</size></plane></geometry>"
           "</collision></link></model></world></sdf>";
    const Outcome outcome = run({(folder / "edge.world").string(), "--script", "forward 0.4", "--width", "64",
                                 "--height", "48", "--output", (folder / "d.rawlog").string(), "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.error.find("goes over an edge of 0.5 m"), std::string::npos) << outcome.error;
}

TEST(SimApp, AnOutputThatCannotBeWrittenIsStatusThree) {
    const Outcome outcome = run(small_drive("/no/such/folder/drive.rawlog"));
    EXPECT_EQ(outcome.status, 3);
    EXPECT_NE(outcome.error.find("/no/such/folder/drive.rawlog"), std::string::npos) << outcome.error;
}

}  // namespace
}  // namespace flownav
