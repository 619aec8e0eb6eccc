#include "calibrate_app.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "app_runs.h"
#include "flownav/config/config.h"
#include "flownav/testing/write_scene.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;

using testing::Outcome;

Outcome run(const std::vector<std::string>& arguments) {
    return testing::run_app(run_calibrate_app, "flownav-calibrate", arguments);
}

fs::path test_folder() {
    return testing::folder_of_test("flownav_calibrate_app");
}

/// A short drive and the path of its calibration.
struct Case {
    fs::path folder = test_folder();
    fs::path rawlog = folder / "drive.rawlog";
    fs::path ini = folder / "camera.ini";
};

Case drive(int images = 90, double speed_mps = 0.6) {
    testing::SceneOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = images;
    options.speed_mps = speed_mps;
    options.camera = testing::standard_camera(320, 240);
    Case result;
    testing::WriteOptions write;
    write.gz_level = 1;
    write.odometry = {1.0, 1.0, 0.0, 0.0};
    testing::write_scene(testing::make_scene(options), result.folder / "drive", write);
    return result;
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(CalibrateApp, FindsPitchRollAndHeightFromAWrongStartAndWritesAnIniThatLoads) {
    const Case c = drive();
    const fs::path picture = c.folder / "residuals.png";
    const Outcome result =
        run({c.rawlog.string(), "--output", c.ini.string(), "--odometry", "--picture", picture.string(),
             "--set", "camera.pitch_deg=31", "--set", "camera.roll_deg=2", "--set", "camera.height_m=1.2",
             "--set", "flow.blocks=200", "--quiet"});
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_TRUE(result.out.empty());
    config::Config config;
    config::load_config_file(config, c.ini.string());
    EXPECT_NEAR(config.camera.pitch_deg.value(), 25.0, 0.3);
    EXPECT_NEAR(config.camera.roll_deg.value(), 0.0, 0.3);
    EXPECT_NEAR(config.camera.height_m.value(), 0.9, 0.015);
    EXPECT_EQ(config.pipeline.flow.blocks, 200);
    EXPECT_NE(text_of(c.ini).find("drive.rawlog"), std::string::npos);
    EXPECT_FALSE(cv::imread(picture.string()).empty());
}

TEST(CalibrateApp, WithoutOdometryTheHeightStaysAndItSaysSo) {
    const Case c = drive(60);
    const Outcome result = run({c.rawlog.string(), "--output", c.ini.string(), "--set", "flow.blocks=200"});
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_NE(result.out.find("height_m: not determined"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("--odometry"), std::string::npos);
    config::Config config;
    config::load_config_file(config, c.ini.string());
    EXPECT_FALSE(config.camera.height_m);
    EXPECT_TRUE(config.camera.pitch_deg);
}

TEST(CalibrateApp, ARobotThatStandsStillDoesNotDetermineAnything) {
    const Case c = drive(30, 0.0005);
    const Outcome result = run({c.rawlog.string(), "--output", c.ini.string(), "--set", "flow.blocks=100"});
    EXPECT_EQ(result.status, 4);
    EXPECT_NE(result.error.find("does not determine"), std::string::npos) << result.error;
    EXPECT_FALSE(fs::exists(c.ini));
}

TEST(CalibrateApp, ADamagedRawlogIsUsedAsFarAsItCanBeRead) {
    const Case c = drive();
    fs::resize_file(c.rawlog, fs::file_size(c.rawlog) * 3 / 4);
    const Outcome result = run({c.rawlog.string(), "--output", c.ini.string(), "--set", "flow.blocks=200"});
    EXPECT_EQ(result.status, 2) << result.error;
    EXPECT_TRUE(fs::exists(c.ini));
}

TEST(CalibrateApp, BadUsageIsStatus1AndAnUnwritableOutput3) {
    const Case c = drive(30);
    EXPECT_EQ(run({}).status, 1);
    EXPECT_EQ(run({c.rawlog.string()}).status, 1);
    EXPECT_EQ(run({c.rawlog.string(), "--output", c.ini.string(), "--set", "camera.pich_deg=1"}).status, 1);
    EXPECT_EQ(run({"no.rawlog", "--output", c.ini.string()}).status, 1);
    EXPECT_EQ(run({c.rawlog.string(), "--output", c.rawlog.string()}).status, 1);
    EXPECT_EQ(run({c.rawlog.string(), "--output", c.ini.string(), "--wrong"}).status, 1);
    EXPECT_EQ(run({c.rawlog.string(), "--output", (c.folder / "none" / "c.ini").string(), "--set",
                   "flow.blocks=100"})
                  .status,
              3);
}

TEST(CalibrateApp, HelpAndVersionAreAnswered) {
    EXPECT_EQ(run({"--help"}).status, 0);
    EXPECT_NE(run({"--help"}).out.find("--odometry"), std::string::npos);
    EXPECT_EQ(run({"--version"}).status, 0);
}

}  // namespace
}  // namespace flownav
