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
        {"video", "a", "--camera", "C.ini", "--output", "o", "--times-unit", "ms"},
        {"tum", "a", "--output", "o"},
        {"tum", "a", "--camera", "C.ini", "--output", "o", "--rate", "5"},
        {"euroc", "a", "b", "--camera", "C.ini", "--output", "o"},
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

TEST(ImportApp, TheUnitOfTimesIsOneOfFour) {
    const auto folder = picture_folder();
    const Outcome outcome =
        run({"images", (folder / "images").string(), "--camera", (folder / "C.ini").string(), "--output",
             (folder / "o").string(), "--times-unit", "hours"});
    EXPECT_EQ(outcome.status, 1);
    expect_names(outcome.error, {"--times-unit hours", "s, ms, us or ns"});
}

TEST(ImportApp, WhatIsRecognisedIsToldWithStatusZeroAndWhatIsMissingWithStatusTwo) {
    const auto folder = picture_folder();
    const auto import = [&](const std::string& times) {
        std::ofstream(folder / "times.txt") << times;
        return run({"images", (folder / "images").string(), "--camera", (folder / "C.ini").string(),
                    "--output", (folder / "o").string(), "--quiet"});
    };
    const Outcome recognised = import("0\n40\n80\n");
    EXPECT_EQ(recognised.status, 0);
    expect_names(recognised.error, {"flownav-import: ", "milliseconds"});
    const Outcome missing = import("0\n0.04\n0.08\n0.12\n");
    EXPECT_EQ(missing.status, 2);
    expect_names(missing.error, {"1 of its 4 times have no image", "the other 3 images were written"});
    const Outcome refused = import("0\n0.04\n");
    EXPECT_EQ(refused.status, 1);
    expect_names(refused.error, {"2 times for 3 images"});
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

/// An odd input of the folder "cases", and what has to be said about it.
struct OddInput {
    std::vector<std::string> arguments;  ///< paths start from the folder
    int status = 0;
    std::uint64_t images = 0;
    std::vector<const char*> sentence;
};

std::vector<OddInput> odd_inputs() {
    const std::vector<std::string> img3 = {"images", "times/img3", "--times"};
    const auto listed = [&](const std::string& list) {
        auto arguments = img3;
        arguments.push_back(list);
        return arguments;
    };
    return {
        {listed("times/nanoseconds.txt"), 0, 3, {"nanoseconds", "0.04 s apart"}},
        {listed("times/milliseconds.txt"), 0, 3, {"milliseconds", "0.04 s apart"}},
        {listed("times/name_first.csv"), 0, 3, {}},
        {listed("times/euroc_data.csv"), 1, 0, {"names none of the images"}},
        {listed("times/tum_rgb.txt"), 1, 0, {"names none of the images"}},
        {{"images", "img_gap"}, 2, 6, {"4 of its 10 times have no image", "numbers in their names"}},
        {{"images", "euroc/mav0/cam0/data"}, 2, 35, {"5 of its 40 times have no image"}},
        {{"images", "euroc"}, 2, 35, {"5 of its 40 times have no image"}},
        {{"euroc", "euroc"}, 2, 35, {"5 of its 40 times have no image"}},
        {{"kitti-raw", "kitti/2011_09_26", "0001"}, 2, 5, {"no timestamps.txt", "1 of 6 images are missing"}},
        {{"kitti-raw", "kitti/2011_09_26", "0002"}, 2, 6, {"0000000002.txt", "no ground truth"}},
        {{"kitti-raw", "kitti/2011_09_26", "0004"}, 1, 0, {"not rectified", "K_02"}},
        {{"video", "video/phone_portrait.mp4"}, 0, 12, {"turned clockwise by 90 degrees"}},
        {{"video", "video/raw_small.mjpeg"}, 1, 0, {"raw_small.mjpeg", "--rate"}},
        {{"video", "grab_video/b30.mp4"}, 0, 30, {}},
    };
}

TEST(ImportApp, OddInputsAreMatchedOrRefusedWithASentence) {
    const fs::path cases = data_folder() / "cases";
    if (!fs::exists(cases)) GTEST_SKIP() << "no folder " << cases;
    for (const OddInput& input : odd_inputs()) {
        const fs::path output = test_folder() / "out.rawlog";
        std::vector<std::string> arguments = input.arguments;
        for (std::size_t i = 1; i < arguments.size(); ++i)
            if (fs::exists(cases / arguments[i])) arguments[i] = (cases / arguments[i]).string();
        arguments.insert(arguments.end(), {"--output", output.string(), "--quiet"});
        if (input.arguments.front() != "kitti-raw")
            arguments.insert(arguments.end(), {"--camera", (cases / "times" / "cam.ini").string()});
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, input.status) << outcome.error;
        for (const char* part : input.sentence) expect_names(outcome.error, {part});
        EXPECT_EQ(outcome.error.empty(), input.sentence.empty()) << outcome.error;
        EXPECT_EQ(fs::exists(output), input.images > 0);
        if (input.images == 0) continue;
        io::RawlogReader reader(output);
        io::FieldSource source(reader, {});
        while (source.next()) continue;
        EXPECT_EQ(source.counts().fields, input.images) << input.arguments[1];
    }
}

}  // namespace
}  // namespace flownav
