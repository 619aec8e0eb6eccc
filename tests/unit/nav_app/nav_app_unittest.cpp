#include "nav_app.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app_runs.h"
#include "drive_files.h"
#include "flownav/drive/simulated_drive.h"
#include "flownav/io/drive_recording.h"
#include "flownav/replay/replay.h"
#include "flownav/sim/generate_world.h"
#include "nav_options.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;

using AppOutcome = testing::Outcome;

AppOutcome run(const std::vector<std::string>& arguments) {
    const auto app = [](const std::vector<std::string>& of, std::ostream& out, std::ostream& error) {
        return run_nav_app(of, out, error);
    };
    return testing::run_app(app, "flownav-nav", arguments);
}

fs::path folder() {
    return testing::folder_of_test("nav_app");
}

std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Valid arguments, followed by `more`.
std::vector<std::string> hall(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"--generate", "hall", "--sensor", "lidar", "--timeout-s", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(NavApp, TellsAboutItself) {
    EXPECT_NE(run({"--help"}).out.find("Exit status:"), std::string::npos);
    EXPECT_EQ(run({"--version"}).out.rfind("flownav-nav ", 0), 0U);
}

TEST(NavApp, TheGuardsKeysAreKeptInTheOptionsOfTheDrive) {
    std::ostringstream out;
    int status = 0;
    std::vector<std::string> arguments =
        hall({"--set", "guard.margin_m=0.15", "--set", "guard.crawl_mps=0.05"});
    arguments.insert(arguments.begin(), "flownav-nav");
    const auto options = parse_nav_options(arguments, out, out, status);
    ASSERT_TRUE(options);
    EXPECT_EQ(options->drive.config.guard.collision_checker.touch_m, 0.15);
    EXPECT_EQ(options->drive.config.guard.collision_checker.crawl_mps, 0.05);
}

TEST(NavApp, BadUsageNamesTheOptionAndWhatIsAllowed) {
    const auto error = [](const std::vector<std::string>& arguments) {
        const AppOutcome result = run(arguments);
        EXPECT_EQ(result.status, 1);
        return result.error;
    };
    EXPECT_NE(error({}).find("--world or --generate"), std::string::npos);
    EXPECT_NE(error({"--generate", "castle"}).find("corridor, office, hall, forest"), std::string::npos);
    EXPECT_NE(error(hall({"--goal", "1;2"})).find("X,Y"), std::string::npos);
    EXPECT_NE(error(hall({"--fov-deg", "170"})).find("10 .. 140"), std::string::npos);
    EXPECT_NE(error({"--generate", "hall", "--sensor", "sonar"}).find("sonar"), std::string::npos);
    EXPECT_NE(error(hall({"--navigator", "sails"})).find("lanes | reactive"), std::string::npos);
    EXPECT_NE(error({"--robot", "tcp:here:1", "--goal", "1,2"}).find("--camera"), std::string::npos);
    EXPECT_NE(error({"--robot", "udp:here:1", "--goal", "1,2"}).find("tcp:HOST:PORT"), std::string::npos);
    EXPECT_NE(error({"--robot", "tcp:here:1", "--generate", "hall"}).find("only with --robot sim"),
              std::string::npos);
    EXPECT_NE(error(hall({"--camera", "cam.ini"})).find("--camera"), std::string::npos);
    EXPECT_NE(error(hall({"--nonsense"})).find("--help"), std::string::npos);
}

TEST(NavApp, ARobotWithoutRoomInItsMapIsRefusedBeforeAnythingIsWritten) {
    const fs::path out = folder() / "drive";
    for (const char* navigator : {"lanes", "reactive"}) {
        const AppOutcome result =
            run(hall({"--navigator", navigator, "--output", out.string(), "--set", "map.size_m=2", "--set",
                      "navigation.footprint_m=-1.5 -0.3 1.5 -0.3 1.5 0.3 -1.5 0.3"}));
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.error.find("map.size_m = 2: too small"), std::string::npos) << result.error;
        EXPECT_FALSE(fs::exists(out));
    }
}

TEST(NavApp, ASimulatedDriveThatIsToldToStopKeepsEverything) {
    const fs::path out = folder();
    int asked = 0;
    bool released = false;
    const StopRequest stop{[&] { return ++asked > 50; }, [&] { released = true; }};
    std::ostringstream text, error;
    const int status =
        run_nav_app({"flownav-nav", "--generate", "hall", "--sensor", "lidar", "--output", out.string()},
                    stop, text, error);
    EXPECT_EQ(status, 7) << error.str();
    EXPECT_TRUE(released);
    EXPECT_EQ(nlohmann::json::parse(content(out / "result.json"))["outcome"], "stopped");
}

TEST(NavApp, WhatCannotBeReadIsNamed) {
    const AppOutcome world = run({"--world", "nowhere.world", "--goal", "1,2"});
    EXPECT_EQ(world.status, 2);
    EXPECT_NE(world.error.find("nowhere.world"), std::string::npos);
    const fs::path list = folder() / "points.txt";
    std::ofstream(list) << "# x y\n1 2\n3 three\n";
    const AppOutcome points = run(hall({"--waypoints", list.string()}));
    EXPECT_EQ(points.status, 2);
    EXPECT_NE(points.error.find("line 3"), std::string::npos);
}

TEST(NavApp, TheTimeBeingOverIsAStatusOfItsOwnAndEverythingIsWritten) {
    const fs::path out = folder();
    const AppOutcome result = run(hall({"--output", out.string()}));
    EXPECT_EQ(result.status, 6) << result.error;
    EXPECT_EQ(result.out.rfind("timeout", 0), 0U);
    const auto json = nlohmann::json::parse(content(out / "result.json"));
    EXPECT_EQ(json["outcome"], "timeout");
    EXPECT_NEAR(json["time_s"], 2.0, 0.05);
    EXPECT_GT(fs::file_size(out / "drive.png"), 1000U);
    EXPECT_EQ(content(out / "drive.csv").rfind("time_s,true_x_m", 0), 0U);
}

TEST(NavApp, ARobotThatFallsEndsWithTheStatusOfACollision) {
    const fs::path out = folder();
    const fs::path world = out / "edge.world";
    std::ofstream(world)
        << "<sdf version='1.9'><world name='edge'><model name='pit'><pose>2 0 -1 0 0 0</pose>"
           "<link name='l'><collision name='c'><geometry><plane><normal>0 0 1</normal>"
           "<size>2 9</size></plane></geometry></collision></link></model></world></sdf>";
    const fs::path file = out / "result.json";
    const AppOutcome result = run({"--world", world.string(), "--goal", "4,0", "--sensor", "lidar",
                                   "--timeout-s", "20", "--result", file.string()});
    EXPECT_EQ(result.status, 5) << result.error << result.out;
    const auto json = nlohmann::json::parse(content(file));
    EXPECT_EQ(json["outcome"], "fell");
    EXPECT_GT(json["contact_speed_mps"], 0.0);
    EXPECT_NE(json["why"].get<std::string>().find("1.00 m deep"), std::string::npos) << json["why"];
}

TEST(NavApp, GeneratedWorldsLookLikeRealRoomsUnlessToldOtherwise) {
    const AppOutcome result = run({"--generate", "hall", "--objects", "shiny"});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.error.find("real, patterned, faint, plain"), std::string::npos) << result.error;
    EXPECT_NE(run({"--generate", "hall", "--floor", "sand"}).error.find("carpet, tiles, lino, plain"),
              std::string::npos);
}

TEST(NavApp, AnOutputThatCannotBeWrittenIsNamed) {
    const fs::path file = folder() / "file";
    std::ofstream(file) << "no folder";
    const AppOutcome result = run(hall({"--output", (file / "below").string()}));
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.error.find(file.string()), std::string::npos);
}

TEST(NavApp, TheRecordingIsKeptThoughTheResultCannotBeWritten) {
    const fs::path record = folder() / "run.rawlog";
    const AppOutcome result = run({"--generate", "corridor", "--width", "160", "--height", "120",
                                   "--timeout-s", "1", "--result", "/dev/full", "--record", record.string()});
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.error.find("/dev/full"), std::string::npos) << result.error;
    EXPECT_TRUE(fs::exists(record));
}

TEST(NavApp, ADriveThatSeesIsRecordedAndReplayedIntoItsReport) {
    const fs::path out = folder();
    const AppOutcome result = run({"--generate", "corridor", "--objects", "patterned", "--width", "320",
                                   "--height", "240", "--timeout-s", "3", "--output", out.string()});
    EXPECT_EQ(result.status, 6) << result.error << result.out;
    for (const char* name : {"run.rawlog", "report.html", "map.pgm", "trajectory.tum", "drive.csv"})
        EXPECT_GT(fs::file_size(out / name), 100U) << name;
    const auto summary = nlohmann::json::parse(content(out / "summary.json"));
    EXPECT_LT(std::abs(summary["errors"]["ground_truth"]["v_bias_percent"].get<double>()), 3.0);
}

TEST(NavApp, TheScoreIsThatOfTheBenchmark) {
    drive::DriveResult result;
    result.outcome = drive::Outcome::Reached;
    const double path_m = 10.0;  // takes 5 s at full speed
    for (const auto& [time_s, score] : {std::pair{4.0, 0.5}, {10.0, 0.5}, {20.0, 0.25}, {90.0, 0.125}}) {
        result.time_s = time_s;
        EXPECT_NEAR(barn_score(result, path_m), score, 1e-9);
    }
    result.outcome = drive::Outcome::Collision;
    EXPECT_EQ(barn_score(result, path_m), 0.0);
}

/// Records a drive, and keeps the obstacle points seen during the drive.
struct Witness : drive::DriveObserver {
    explicit Witness(const fs::path& file) : recording(file) {}

    void on_field(const Field& field, const pipeline::Step& step) override {
        recording.write(field);
        for (const ObstaclePoint& point : step.obstacles) seen.push_back(point.position_m);
    }

    io::DriveRecording recording;
    std::vector<Eigen::Vector3d> seen;
};

/// Reads the points of an obstacles.csv.
std::vector<Eigen::Vector3d> points_of(const fs::path& csv) {
    std::istringstream lines(content(csv));
    std::string line;
    std::getline(lines, line);
    std::vector<Eigen::Vector3d> points;
    while (std::getline(lines, line)) {
        Eigen::Vector3d p;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        double timestamp_s;
        words >> timestamp_s >> p.x() >> p.y() >> p.z();
        points.push_back(p);
    }
    return points;
}

TEST(NavApp, TheRecordingOfADriveReplaysToTheObstaclesThatTheRobotSaw) {
    drive::SimulatedDriveOptions drive;
    drive.world = sim::generate_world(sim::WorldKind::Forest, 1);
    drive.start = drive.world.start;
    drive.goals_m = {*drive.world.goal};
    drive.timeout_s = 8.0;
    CameraModel& camera = drive.camera.camera;
    camera.width_px = 320;
    camera.height_px = 240;
    camera.fx_px = camera.fy_px = 160.0;
    camera.cx_px = 159.5;
    camera.cy_px = 119.5;
    camera.mount.height_m = 0.5;
    camera.mount.pitch_rad = 0.35;
    replay::ReplayOptions replaying;
    replaying.output = folder();
    replaying.input = replaying.output / "run.rawlog";
    Witness witness(replaying.input);
    drive::simulate_drive(drive, witness);
    witness.recording.complete();
    replay::replay(replaying);
    const auto replayed = points_of(replaying.output / "obstacles.csv");
    ASSERT_GT(witness.seen.size(), 50U);
    ASSERT_EQ(replayed.size(), witness.seen.size());
    for (std::size_t i = 0; i < replayed.size(); ++i)
        EXPECT_LT((replayed[i] - witness.seen[i]).norm(), 2e-4) << i;
}

}  // namespace
}  // namespace flownav
