#include "import_app.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "app_runs.h"
#include "flownav/core/version.h"
#include "flownav/flow/kernel.h"
#include "flownav/io/field_source.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;

using testing::Outcome;

Outcome run(const std::vector<std::string>& arguments) {
    return testing::run_app(run_import_app, "flownav-import", arguments);
}

fs::path test_folder() {
    return testing::folder_of_test("flownav_import_app");
}

constexpr auto camera_ini =
    "[camera]\nfx_px = 60\nfy_px = 60\ncx_px = 31.5\ncy_px = 23.5\nheight_m = 0.5\npitch_deg = 10\n";

/// Creates a folder with pictures and C.ini.
fs::path picture_folder() {
    const fs::path folder = test_folder();
    fs::create_directories(folder / "images");
    for (int i = 0; i < 3; ++i) {
        cv::imwrite((folder / "images" / (std::to_string(i) + ".png")).string(),
                    cv::Mat(48, 64, CV_8UC1, cv::Scalar(40 + i)));
    }
    std::ofstream(folder / "C.ini") << camera_ini;
    return folder;
}

void expect_names(const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
}

TEST(ImportApp, HelpAndVersionGoToTheOutputWithStatusZero) {
    const Outcome help = run({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_TRUE(help.error.empty());
    expect_names(help.out, {"kitti-odometry", "kitti-raw", "images", "video", "Exit status", "--times"});
    EXPECT_EQ(run({"images", "--help"}).status, 0);
    EXPECT_EQ(run({"--version"}).out, "flownav-import " + std::string(version()) +
                                          "\nmatching kernel: " + flow::default_kernel().name + "\n");
}

TEST(ImportApp, BadUsageIsStatusOneAndPointsToHelp) {
    const std::vector<std::vector<std::string>> cases = {
        {},
        {"films"},
        {"images"},
        {"images", "a", "b", "--camera", "C.ini", "--output", "o"},
        {"images", "a", "--output", "o"},
        {"images", "a", "--camera", "C.ini"},
        {"kitti-odometry", "a", "--output", "o"},
        {"kitti-odometry", "a", "00", "--output", "o", "--rate", "10"},
        {"kitti-odometry", "a", "00", "--output", "o", "--camera", "C.ini"},
        {"video", "a", "--camera", "C.ini", "--output", "o", "--height-m", "1"},
        {"video", "a", "--camera", "C.ini", "--output", "o", "--times", "t.csv"},
        {"images", "a", "--camera", "C.ini", "--output", "o", "--times", "t.csv", "--rate", "5"},
        {"images", "a", "--unknown"},
        {"video", "a", "--camera", "C.ini", "--output", "o", "--rate", "fast"},
    };
    for (const auto& arguments : cases) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_TRUE(outcome.out.empty()) << outcome.out;
        expect_names(outcome.error, {"flownav-import: ", "--help"});
    }
}

TEST(ImportApp, ValuesOutOfRangeAreNamed) {
    expect_names(run({"kitti-odometry", "a", "00", "--output", "o", "--height-m", "-1"}).error,
                 {"height_m", "-1"});
    expect_names(run({"kitti-odometry", "a", "00", "--output", "o", "--pitch-deg", "x"}).error,
                 {"pitch_deg", "x"});
    const auto folder = picture_folder();
    const Outcome rate = run({"images", (folder / "images").string(), "--camera", (folder / "C.ini").string(),
                              "--output", (folder / "o").string(), "--rate", "0"});
    EXPECT_EQ(rate.status, 1);
    expect_names(rate.error, {"--rate"});
    expect_names(run({"images", "a", "--camera", (folder / "none.ini").string(), "--output", "o"}).error,
                 {"none.ini"});
}

TEST(ImportApp, PicturesBecomeARawlog) {
    const auto folder = picture_folder();
    const auto output = folder / "out.rawlog";
    const Outcome outcome =
        run({"images", (folder / "images").string(), "--camera", (folder / "C.ini").string(), "--output",
             output.string(), "--rate", "10", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
    io::RawlogReader reader(output);
    io::FieldSource source(reader, {});
    while (source.next()) continue;
    EXPECT_EQ(source.counts().fields, 3U);
    EXPECT_EQ(reader.end().kind, io::ReadEnd::Kind::Clean);
}

TEST(ImportApp, DamagedPictureIsStatusTwoAndTheOthersAreWritten) {
    const auto folder = picture_folder();
    std::ofstream(folder / "images" / "1.png") << "no picture";
    const Outcome outcome =
        run({"images", (folder / "images").string(), "--camera", (folder / "C.ini").string(), "--output",
             (folder / "o").string(), "--quiet"});
    EXPECT_EQ(outcome.status, 2);
    expect_names(outcome.error, {"1.png", "cannot be read"});
    EXPECT_TRUE(fs::exists(folder / "o"));
}

TEST(ImportApp, MissingSourceIsStatusOne) {
    const auto folder = picture_folder();
    const std::string ini = (folder / "C.ini").string();
    EXPECT_EQ(run({"images", "/nowhere", "--camera", ini, "--output", (folder / "o").string()}).status, 1);
    EXPECT_EQ(run({"video", "/nowhere", "--camera", ini, "--output", (folder / "o").string()}).status, 1);
    EXPECT_EQ(run({"kitti-raw", "/nowhere", "1", "--output", (folder / "o").string()}).status, 1);
    EXPECT_FALSE(fs::exists(folder / "o"));
}

TEST(ImportApp, UnwritableOutputIsStatusThree) {
    const auto folder = picture_folder();
    for (const std::string output : {"/dev/full", "/nowhere/out.rawlog"}) {
        const Outcome outcome = run({"images", (folder / "images").string(), "--camera",
                                     (folder / "C.ini").string(), "--output", output, "--quiet"});
        EXPECT_EQ(outcome.status, 3);
        expect_names(outcome.error, {output.c_str()});
    }
}

fs::path data_folder() {
    const char* environment = std::getenv("FLOWNAV_DATA");
    return environment != nullptr ? fs::path(environment) : fs::path(FLOWNAV_DATA_DIR);
}

TEST(ImportApp, KittiSequenceHasTheMotionOfTheCar) {
    const fs::path data = data_folder() / "kitti-odometry";
    if (!fs::exists(data)) GTEST_SKIP() << "no data set at " << data;
    const auto output = test_folder() / "kitti.rawlog";
    const Outcome outcome =
        run({"kitti-odometry", data.string(), "00", "--output", output.string(), "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    io::RawlogReader reader(output);
    io::FieldSource source(reader, {});
    std::vector<io::PoseSample> poses;
    while (const auto event = source.next()) {
        if (const auto* pose = std::get_if<io::PoseSample>(&*event)) poses.push_back(*pose);
    }
    EXPECT_EQ(source.counts().fields, 100U);
    EXPECT_TRUE(source.counts().rejected.empty());
    ASSERT_EQ(poses.size(), 100U);
    for (std::size_t i = 1; i < poses.size(); ++i) {
        const double dx = poses[i].pose.x - poses[i - 1].pose.x;
        const double dy = poses[i].pose.y - poses[i - 1].pose.y;
        EXPECT_GT(std::hypot(dx, dy), 0.4) << i;
        EXPECT_LT(std::hypot(dx, dy), 1.1) << i;
        // The rear axle hardly slips sideways; the camera ahead of it swings out by 0.02 m and more in the
        // bend.
        const double turn = poses[i].pose.yaw - poses[i - 1].pose.yaw;
        const double middle = poses[i - 1].pose.yaw + turn / 2;
        const double sideways = -std::sin(middle) * dx + std::cos(middle) * dy;
        EXPECT_NEAR(sideways, 0, std::abs(turn) > 0.017 ? 0.015 : 0.05) << i;
    }
}

}  // namespace
}  // namespace flownav
