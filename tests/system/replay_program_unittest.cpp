#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core/mat.hpp>
#include <set>
#include <sstream>

#include "flownav/io/rawlog_reader.h"
#include "program.h"
#include "rawlog_files.h"

/// The command line of flownav-replay: exit status, messages, files.
namespace flownav {
namespace {

namespace fs = std::filesystem;
using testing::Outcome;
using testing::write_bytes;

const std::string corridor = FLOWNAV_CORRIDOR;

/// Every file of a replay of a recording with odometry and ground truth.
const std::set<std::string> every_file = {
    "trajectory.tum", "odometry.tum", "ground_truth.tum", "egomotion.csv", "obstacles.csv", "contacts.csv",
    "map.pgm",        "map.yaml",     "map.gridmap.gz",   "result.rawlog", "summary.json",  "report.html"};

std::string content(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> names;
    if (!fs::exists(folder)) return names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
    return names;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::size_t lines_of(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

class ReplayProgram : public ::testing::Test {
  protected:
    Outcome replay(const std::string& input, const std::vector<std::string>& more = {}) const {
        return replay_to(output, input, more);
    }

    Outcome replay_to(const fs::path& folder, const std::string& input,
                      const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {input, "--output", folder};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return testing::run_program(FLOWNAV_REPLAY, arguments, scratch);
    }

    /// A small recording of noise: all of it can be read, but the sensor gets no result from it.
    std::string small_rawlog() const {
        const fs::path file = scratch / "small.rawlog";
        write_bytes(file, testing::gz(testing::serialized(testing::small_recording())));
        return file;
    }

    nlohmann::json summary() const { return nlohmann::json::parse(content(output / "summary.json")); }

    const fs::path scratch = testing::test_folder();
    const fs::path output = scratch / "out";
};

void expect_refused(const Outcome& outcome, const std::string& part, const fs::path& output) {
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(has(outcome.error, part)) << outcome.error;
    EXPECT_TRUE(has(outcome.error, "flownav-replay: ")) << outcome.error;
    EXPECT_LE(lines_of(outcome.error), 2U) << outcome.error;
    EXPECT_FALSE(fs::exists(output)) << "nothing is written";
}

// ---- all is well

TEST_F(ReplayProgram, WritesEveryFileOfAGoodRecording) {
    const Outcome outcome = replay(corridor);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(files_in(output), every_file);
    EXPECT_TRUE(has(outcome.out, "100 %")) << "plain lines where there is no terminal";
    EXPECT_FALSE(has(outcome.out, "\r"));
    EXPECT_TRUE(has(outcome.out, "report.html"));
    const auto json = summary();
    EXPECT_EQ(json["input"]["end"], "clean");
    EXPECT_EQ(json["read"]["fields"], json["written"]["trajectory_poses"]);
    EXPECT_EQ(lines_of(content(output / "trajectory.tum")), json["read"]["fields"]);
    EXPECT_EQ(lines_of(content(output / "egomotion.csv")), json["read"]["fields"].get<std::size_t>() + 1);
    EXPECT_EQ(lines_of(content(output / "obstacles.csv")),
              json["written"]["obstacle_points"].get<std::size_t>() + 1);
    EXPECT_EQ(lines_of(content(output / "contacts.csv")), json["contacts"]["rows"].get<std::size_t>() + 1);
    EXPECT_GT(json["status"]["ok"], 10);
    EXPECT_GT(json["written"]["obstacle_points"], 10);
}

TEST_F(ReplayProgram, QuietSaysNothing) {
    const Outcome outcome = replay(small_rawlog(), {"--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error, "");
}

TEST_F(ReplayProgram, TrajectoriesStartAtTheIdentityAtTheFirstField) {
    ASSERT_EQ(replay(corridor).status, 0);
    std::string first;
    for (const char* name : {"trajectory.tum", "odometry.tum", "ground_truth.tum"}) {
        const std::string text = content(output / name);
        const std::string line = text.substr(0, text.find('\n'));
        EXPECT_TRUE(has(line, " 0.000000 0.000000 0.000000 0.000000000 0.000000000 0.000000000 1.000000000"))
            << line;
        if (first.empty()) first = line;
        EXPECT_EQ(line, first) << name;
    }
}

TEST_F(ReplayProgram, TwoRunsAndTwoThreadsGiveTheSameBytes) {
    ASSERT_EQ(replay_to(scratch / "a", corridor).status, 0);
    ASSERT_EQ(replay_to(scratch / "b", corridor, {"--threads", "2"}).status, 0);
    for (const std::string& name : every_file) {
        if (name == "summary.json") continue;
        EXPECT_TRUE(content(scratch / "a" / name) == content(scratch / "b" / name)) << name;
    }
    auto a = nlohmann::ordered_json::parse(content(scratch / "a" / "summary.json"));
    auto b = nlohmann::ordered_json::parse(content(scratch / "b" / "summary.json"));
    EXPECT_EQ(a["timing"]["threads"], 1);
    EXPECT_EQ(b["timing"]["threads"], 2);
    a.erase("timing");
    b.erase("timing");
    EXPECT_EQ(a.dump(), b.dump());
}

TEST_F(ReplayProgram, TheFileMayLieAnywhere) {
    fs::create_directories(scratch / "deep");
    fs::copy_file(corridor, scratch / "deep" / "corridor.rawlog");
    ASSERT_EQ(replay_to(scratch / "a", corridor).status, 0);
    ASSERT_EQ(replay_to(scratch / "b", scratch / "deep" / "corridor.rawlog").status, 0);
    EXPECT_TRUE(content(scratch / "a" / "report.html") == content(scratch / "b" / "report.html"));
}

TEST_F(ReplayProgram, ASecondReplayReplacesTheFirst) {
    ASSERT_EQ(replay(corridor).status, 0);
    auto objects = testing::small_recording();
    objects.erase(std::remove_if(objects.begin(), objects.end(),
                                 [](const auto& object) {
                                     return object->GetRuntimeClass() !=
                                            CLASS_ID(mrpt::obs::CObservationImage);
                                 }),
                  objects.end());
    write_bytes(scratch / "images.rawlog", testing::serialized(objects));
    ASSERT_EQ(replay(scratch / "images.rawlog").status, 0);
    auto expected = every_file;
    expected.erase("odometry.tum");
    expected.erase("ground_truth.tum");
    EXPECT_EQ(files_in(output), expected) << "tracks of the first recording must not stay";
    EXPECT_TRUE(summary()["errors"]["ground_truth"].is_null());
}

TEST_F(ReplayProgram, KeptImagesMakeAResultThatReplaysLikeItsInput) {
    ASSERT_EQ(replay_to(scratch / "a", corridor, {"--keep-images"}).status, 0);
    ASSERT_EQ(replay_to(scratch / "b", scratch / "a" / "result.rawlog").status, 0);
    EXPECT_TRUE(content(scratch / "a" / "egomotion.csv") == content(scratch / "b" / "egomotion.csv"));
    EXPECT_TRUE(content(scratch / "a" / "obstacles.csv") == content(scratch / "b" / "obstacles.csv"));
}

TEST_F(ReplayProgram, SettingsOnTheCommandLineComeAfterTheFile) {
    write_bytes(scratch / "my.ini", "[flow]\nblocks = 100\n[obstacles]\ntau_px = 2\n");
    ASSERT_EQ(replay(small_rawlog(), {"--config", scratch / "my.ini", "--set", "flow.blocks=50"}).status, 0);
    EXPECT_EQ(summary()["config"]["flow"]["blocks"], "50");
    EXPECT_EQ(summary()["config"]["obstacles"]["tau_px"], "2");
}

TEST_F(ReplayProgram, ARightCameraPoseIsConsistentAndNothingIsSaid) {
    const Outcome run = replay(corridor);
    EXPECT_EQ(run.error, "");
    EXPECT_EQ(summary()["camera_check"]["verdict"], "consistent");
}

TEST_F(ReplayProgram, ACameraPoseThatContradictsTheFlowIsReportedEverywhere) {
    const Outcome run = replay(corridor, {"--set", "camera.pitch_deg=30"});
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(has(run.error, "warning: camera.pitch_deg = 30.00 contradicts the flow")) << run.error;
    const auto check = summary()["camera_check"];
    EXPECT_EQ(check["verdict"], "pose_contradicts_flow");
    EXPECT_NEAR(check["pitch_error_deg"].get<double>(), -5.0, 1.0);
    EXPECT_TRUE(has(content(output / "report.html"), "contradicts the flow of the floor"));
}

TEST_F(ReplayProgram, BothMatchersDriveThroughTheCorridor) {
    for (const std::string matcher : {"sad", "lk"}) {
        ASSERT_EQ(replay(corridor, {"--quiet", "--set", "flow.matcher=" + matcher}).status, 0);
        const auto json = summary();
        EXPECT_EQ(json["config"]["flow"]["matcher"], matcher);
        EXPECT_EQ(json["timing"]["kernel"] == "lk", matcher == "lk");
        EXPECT_LT(json["errors"]["ground_truth"]["omega_rms_degps"], 0.2) << matcher;
        EXPECT_GT(json["written"]["obstacle_points"], 50) << matcher;
    }
}

TEST_F(ReplayProgram, MemoryStaysFlatOverALongRecording) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer keeps what was freed";
#endif
    const auto repeated = [&](int times) {
        fs::path file = scratch / ("repeated" + std::to_string(times) + ".rawlog");
        mrpt::io::CFileGZOutputStream stream(file.string(), mrpt::io::OpenMode::TRUNCATE, 1);
        for (int k = 0; k < times; ++k) {
            io::RawlogReader reader(corridor);
            while (const auto observation = reader.next()) {
                observation->timestamp += std::chrono::seconds(60 * k);
                mrpt::serialization::archiveFrom(stream) << *observation;
            }
        }
        stream.close();
        return file;
    };
    const Outcome once = replay(repeated(1), {"--quiet"});
    ASSERT_EQ(once.status, 0) << once.error;
    const Outcome often = replay(repeated(10), {"--quiet"});
    ASSERT_EQ(often.status, 0) << often.error;
    // Ten times the images; memory may grow by a small row per field, and by the pictures of the report up to
    // a limit.
    EXPECT_LT(often.peak_memory_kb, once.peak_memory_kb + 40000);
}

// ---- bad usage and configuration: status 1, nothing written

TEST_F(ReplayProgram, MissingArgumentsAreNamed) {
    expect_refused(testing::run_program(FLOWNAV_REPLAY, {}, scratch), "INPUT.rawlog and --output DIR",
                   output);
    expect_refused(testing::run_program(FLOWNAV_REPLAY, {corridor}, scratch), "--output DIR", output);
}

TEST_F(ReplayProgram, ArgumentsThatMakeNoSenseAreRefused) {
    const std::string input = small_rawlog();
    expect_refused(replay(input, {"--bad"}), "--bad", output);
    expect_refused(replay(input, {"another.rawlog"}), "another.rawlog", output);
    expect_refused(replay(input, {"--threads", "many"}), "many", output);
    expect_refused(replay(input, {"--threads", "0"}), "1..64", output);
    expect_refused(replay(input, {"--set", "flow.blocks"}), "section.key=value", output);
    expect_refused(replay(input, {"--for-s", "1"}), "--realtime", output);
    expect_refused(replay(input, {"--realtime", "--for-s", "0"}), "--for-s", output);
    expect_refused(replay(input, {"--realtime", "--keep-images"}), "--keep-images", output);
}

TEST_F(ReplayProgram, NoSuchInputIsBadUsage) {
    expect_refused(replay(scratch / "none.rawlog"), "none.rawlog", output);
    expect_refused(replay(scratch), "is a folder", output);
}

TEST_F(ReplayProgram, UnknownKeysNameTheNearestKnownOne) {
    expect_refused(replay(small_rawlog(), {"--set", "flow.blcks=100"}), "flow.blocks", output);
    write_bytes(scratch / "bad.ini", "[flow]\nblcks = 100\n");
    expect_refused(replay(small_rawlog(), {"--config", scratch / "bad.ini"}), "blocks", output);
}

TEST_F(ReplayProgram, ValuesOutOfRangeNameKeyValueAndRange) {
    expect_refused(replay(small_rawlog(), {"--set", "flow.blocks=5"}), "flow.blocks = 5", output);
    expect_refused(replay(small_rawlog(), {"--set", "camera.height_m=0"}), "camera.height_m", output);
    write_bytes(scratch / "nan.ini", "[camera]\nheight_m = nan\n");
    expect_refused(replay(small_rawlog(), {"--config", scratch / "nan.ini"}), "height_m", output);
    expect_refused(replay(small_rawlog(), {"--config", scratch / "none.ini"}), "none.ini", output);
}

TEST_F(ReplayProgram, ARecordingWithoutImagesOfTheCameraNamesWhatItHolds) {
    const Outcome outcome = replay(small_rawlog(), {"--quiet", "--set", "camera.camera_label=FRONT"});
    expect_refused(outcome, "CAMERA1", output);
    EXPECT_TRUE(has(outcome.error, "camera.camera_label"));
}

TEST_F(ReplayProgram, AnImageWithoutCalibrationNamesTheKeysToSet) {
    const auto image = testing::image_at(100);
    image->cameraParams = {};
    write_bytes(scratch / "raw.rawlog", testing::serialized({image}));
    const Outcome outcome = replay(scratch / "raw.rawlog", {"--quiet"});
    expect_refused(outcome, "fx_px", output);
}

TEST_F(ReplayProgram, ACameraThatLooksUpIsRefused) {
    const auto image = testing::image_at(100);
    image->cameraPose = mrpt::poses::CPose3D(0, 0, 0.5, -M_PI / 2, 0, -M_PI / 2 + 0.5);
    write_bytes(scratch / "up.rawlog", testing::serialized({image}));
    expect_refused(replay(scratch / "up.rawlog", {"--quiet"}), "pitch", output);
}

TEST_F(ReplayProgram, TheInputIsNeverOverwritten) {
    fs::create_directories(output);
    const fs::path input = output / "result.rawlog";
    fs::copy_file(small_rawlog(), input);
    const std::string before = content(input);
    const Outcome outcome = replay(input);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(has(outcome.error, "--output")) << outcome.error;
    EXPECT_EQ(content(input), before);
}

// ---- damaged input: status 2, all that was readable is written

TEST_F(ReplayProgram, AnEmptyFileEndsWithTwoAndASummary) {
    write_bytes(scratch / "empty.rawlog", "");
    const Outcome outcome = replay(scratch / "empty.rawlog", {"--quiet"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(has(outcome.error, "empty")) << outcome.error;
    EXPECT_NE(summary()["input"]["end"], "clean");
    EXPECT_EQ(summary()["read"]["fields"], 0);
    EXPECT_EQ(lines_of(content(output / "egomotion.csv")), 1U);
    EXPECT_TRUE(fs::exists(output / "report.html"));
}

TEST_F(ReplayProgram, WhatIsNoRawlogEndsWithTwo) {
    write_bytes(scratch / "text.rawlog", "Dear diary, today the robot drove into a wall.\n");
    write_bytes(scratch / "image.png",
                std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + std::string(100, 'x'));
    for (const char* name : {"text.rawlog", "image.png"}) {
        const Outcome outcome = replay(scratch / name, {"--quiet"});
        EXPECT_EQ(outcome.status, 2) << name;
        EXPECT_TRUE(has(outcome.error, name)) << outcome.error;
        EXPECT_TRUE(has(summary()["input"]["message"], "rawlog"));
        EXPECT_FALSE(has(summary()["input"]["message"], scratch.string())) << "no path of this machine";
    }
}

TEST_F(ReplayProgram, ACutRecordingIsUsedUpToTheCut) {
    const std::string bytes = content(corridor);
    write_bytes(scratch / "cut.rawlog", bytes.substr(0, bytes.size() / 2));
    const Outcome outcome = replay(scratch / "cut.rawlog", {"--quiet"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_LE(lines_of(outcome.error), 2U) << outcome.error;
    EXPECT_EQ(summary()["input"]["end"], "truncated");
    EXPECT_GT(summary()["read"]["fields"], 5);
    EXPECT_EQ(lines_of(content(output / "egomotion.csv")),
              summary()["read"]["fields"].get<std::size_t>() + 1);
    EXPECT_EQ(files_in(output), every_file);
}

TEST_F(ReplayProgram, ACutRecordingGivesTheSameWithTwoThreads) {
    const std::string bytes = content(corridor);
    write_bytes(scratch / "cut.rawlog", bytes.substr(0, bytes.size() / 2));
    const Outcome a = replay_to(scratch / "a", scratch / "cut.rawlog", {"--quiet"});
    const Outcome b = replay_to(scratch / "b", scratch / "cut.rawlog", {"--quiet", "--threads", "2"});
    EXPECT_EQ(b.status, 2);
    EXPECT_EQ(a.error, b.error);
    for (const std::string& name : every_file) {
        if (name == "summary.json") continue;
        EXPECT_TRUE(content(scratch / "a" / name) == content(scratch / "b" / name)) << name;
    }
}

TEST_F(ReplayProgram, ARunInRealTimeReportsItsLatencyAndWritesNothingElse) {
    const Outcome outcome = replay(corridor, {"--realtime", "--for-s", "0.2"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto json = nlohmann::json::parse(content(output / "realtime.json"));
    EXPECT_GE(json["fields"], 2);
    EXPECT_LT(json["dropped"], json["fields"]);
    const auto& latency = json["latency_ms"];
    EXPECT_GT(latency["median"], 0.0);
    EXPECT_LE(latency["median"], latency["p99"]);
    EXPECT_LE(latency["p99"], latency["p99_9"]);
    EXPECT_LE(latency["p99_9"], latency["worst"]);
    EXPECT_EQ(files_in(output), std::set<std::string>{"realtime.json"});
}

TEST_F(ReplayProgram, AFlippedBitIsNoticed) {
    std::string bytes = content(corridor);
    bytes[bytes.size() * 3 / 4] ^= 0x10;
    write_bytes(scratch / "flipped.rawlog", bytes);
    const Outcome outcome = replay(scratch / "flipped.rawlog", {"--quiet"});
    EXPECT_EQ(outcome.status, 2) << outcome.error;
    EXPECT_NE(summary()["input"]["end"], "clean");
    EXPECT_GT(summary()["read"]["fields"], 5);
}

TEST_F(ReplayProgram, AnImageThatCannotBeUsedMidwayLosesNothingBeforeIt) {
    auto objects = testing::small_recording();
    const auto image = testing::image_at(200);
    image->cameraParams = {};
    objects.push_back(image);
    write_bytes(scratch / "midway.rawlog", testing::serialized(objects));
    const Outcome outcome = replay(scratch / "midway.rawlog", {"--quiet"});
    EXPECT_EQ(outcome.status, 2) << outcome.error;
    EXPECT_TRUE(has(outcome.error, "fx_px")) << outcome.error;
    EXPECT_EQ(summary()["input"]["end"], "unusable_image");
    EXPECT_EQ(summary()["written"]["trajectory_poses"], 8);
}

// ---- output that cannot be written: status 3

TEST_F(ReplayProgram, AnOutputThatIsNoFolderEndsWithThree) {
    const Outcome device = replay_to("/dev/full", small_rawlog(), {"--quiet"});
    EXPECT_EQ(device.status, 3);
    EXPECT_TRUE(has(device.error, "/dev/full")) << device.error;
    write_bytes(scratch / "file", "");
    EXPECT_EQ(replay_to(scratch / "file" / "out", small_rawlog(), {"--quiet"}).status, 3);
    EXPECT_EQ(replay_to("/proc/flownav", small_rawlog(), {"--quiet"}).status, 3);
}

TEST_F(ReplayProgram, AFolderWithoutPermissionEndsWithThree) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    fs::create_directories(output);
    fs::permissions(output, fs::perms::owner_read | fs::perms::owner_exec);
    const Outcome outcome = replay(small_rawlog(), {"--quiet"});
    fs::permissions(output, fs::perms::owner_all);
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(has(outcome.error, "Permission denied")) << outcome.error;
}

TEST_F(ReplayProgram, AFullDiskEndsWithThreeAndNamesTheFile) {
    for (const std::string& name : every_file) {
        if (name == "odometry.tum" || name == "ground_truth.tum")
            continue;  // renamed into place, not written directly
        fs::remove_all(output);
        fs::create_directories(output);
        fs::create_symlink("/dev/full", output / name);
        const Outcome outcome = replay(small_rawlog(), {"--quiet"});
        EXPECT_EQ(outcome.status, 3) << name;
        EXPECT_TRUE(has(outcome.error, (output / name).string())) << outcome.error;
        const bool reason = has(outcome.error, "No space left on device") || has(outcome.error, "disk full");
        EXPECT_TRUE(reason) << outcome.error;
    }
}

TEST_F(ReplayProgram, AFullDiskAtTheEndLosesNothingMeasured) {
    fs::create_directories(output);
    fs::create_symlink("/dev/full", output / "report.html");
    EXPECT_EQ(replay(corridor, {"--quiet"}).status, 3);
    EXPECT_GT(lines_of(content(output / "trajectory.tum")), 10U);
    EXPECT_GT(lines_of(content(output / "obstacles.csv")), 10U);
}

TEST_F(ReplayProgram, AFolderInTheWayEndsWithThree) {
    for (const std::string& name : every_file) {
        fs::remove_all(output);
        fs::create_directories(output / name / "full");
        const Outcome outcome = replay(small_rawlog(), {"--quiet"});
        EXPECT_EQ(outcome.status, 3) << name << ": " << outcome.error;
        EXPECT_TRUE(has(outcome.error, name)) << outcome.error;
    }
}

TEST_F(ReplayProgram, ADiskThatIsFullInTheMiddleOfTheImagesEndsWithThree) {
    fs::create_directories(output);
    fs::create_symlink("/dev/full", output / "result.rawlog");
    const Outcome outcome = replay(corridor, {"--quiet", "--keep-images"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(has(outcome.error, "result.rawlog")) << outcome.error;
}

// ---- the record of every field

TEST_F(ReplayProgram, AFlowFieldFileHasOneRecordAFieldAndChangesNoResult) {
    const fs::path fields = scratch / "fields.rawlog";
    const Outcome outcome = replay(corridor, {"--quiet", "--flow-field", fields});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(files_in(output), every_file);
    const fs::path plain = scratch / "plain";
    ASSERT_EQ(replay_to(plain, corridor, {"--quiet"}).status, 0);
    EXPECT_EQ(content(output / "result.rawlog"), content(plain / "result.rawlog"));
    io::RawlogReader reader(fields);
    std::size_t count = 0;
    while (reader.next()) ++count;
    EXPECT_EQ(reader.end().kind, io::ReadEnd::Kind::Clean) << reader.end().message;
    EXPECT_EQ(count, summary()["read"]["fields"]);
}

TEST_F(ReplayProgram, AFlowFieldFileOverwritesNeitherTheInputNorAResult) {
    const std::string input = small_rawlog();
    for (const fs::path& file : {fs::path(input), output / "summary.json", output / "." / "result.rawlog"}) {
        expect_refused(replay(input, {"--flow-field", file}), "would overwrite", output);
    }
    expect_refused(replay(input, {"--flow-field", scratch / "x", "--video", scratch / "x"}), "same file",
                   output);
}

TEST_F(ReplayProgram, WhatEncodesVideosIsNotLoadedWithTheProgram) {
    const Outcome libraries = testing::run_program("/usr/bin/env", {"ldd", FLOWNAV_REPLAY}, scratch);
    EXPECT_TRUE(has(libraries.out, "libopencv_core")) << libraries.out;
    EXPECT_FALSE(has(libraries.out, "libopencv_videoio")) << "18 MB, and 100 libraries of FFmpeg's";
}

TEST_F(ReplayProgram, AFlowFieldFileOnAFullDiskEndsWithThree) {
    const Outcome outcome = replay(small_rawlog(), {"--quiet", "--flow-field", "/dev/full"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(has(outcome.error, "/dev/full")) << outcome.error;
}

// ---- invalid images

TEST_F(ReplayProgram, BlackWhiteAndConstantFieldsGetAStatusWord) {
    std::vector<mrpt::serialization::CSerializable::ConstPtr> objects;
    const std::vector<std::uint8_t> greys = {0, 0, 255, 255, 128, 128};
    for (std::size_t i = 0; i < greys.size(); ++i) {
        const auto image = testing::image_at(100 + 0.04 * static_cast<double>(i));
        image->image =
            mrpt::img::CImage(cv::Mat(48, 64, CV_8UC1, cv::Scalar(greys[i])), mrpt::img::DEEP_COPY);
        objects.push_back(image);
    }
    write_bytes(scratch / "dull.rawlog", testing::serialized(objects));
    const Outcome outcome = replay(scratch / "dull.rawlog", {"--quiet"});
    EXPECT_EQ(outcome.status, 2) << outcome.error;
    EXPECT_EQ(summary()["status"]["bad_field"], 6);
    const std::string csv = content(output / "egomotion.csv");
    EXPECT_FALSE(has(csv, "nan"));
    EXPECT_TRUE(has(csv, "100.000000,bad_field,,,"));
    EXPECT_EQ(lines_of(content(output / "obstacles.csv")), 1U);
}

TEST_F(ReplayProgram, AWarningIsPrintedAndInTheSummaryAndStrictMakesItStatusTwo) {
    const std::vector<std::string> other_label = {"--set", "input.odometry_label=wheels"};
    const Outcome told = replay(corridor, other_label);
    EXPECT_EQ(told.status, 0);
    EXPECT_TRUE(has(told.error, "warning: 60 poses of the odometry were ignored")) << told.error;
    EXPECT_TRUE(has(told.error, "input.odometry_label = ODOMETRY")) << told.error;
    const auto warnings = summary()["warnings"];
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0]["reason"], "odometry_label");
    EXPECT_EQ(warnings[0]["loses_data"], false);
    EXPECT_TRUE(has(content(output / "report.html"), "poses of the odometry were ignored"));
    EXPECT_EQ(replay(corridor, {"--set", "input.odometry_label=wheels", "--strict"}).status, 2);
    EXPECT_EQ(replay(corridor, {"--strict"}).status, 0);
}

TEST_F(ReplayProgram, RealtimeDoesNotWaitForAnHour) {
    std::vector<mrpt::serialization::CSerializable::ConstPtr> objects;
    for (int i = 0; i < 20; ++i)
        objects.push_back(
            testing::image_at(100 + 0.04 * i + (i < 10 ? 0.0 : 3600.0), static_cast<unsigned>(i)));
    const fs::path file = scratch / "pause.rawlog";
    write_bytes(file, testing::serialized(objects));
    const auto began = std::chrono::steady_clock::now();
    const Outcome outcome = testing::run_program(FLOWNAV_REPLAY, {file, "--realtime"}, scratch);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_TRUE(has(outcome.error, "1 pause was cut short by 3598.0 s")) << outcome.error;
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(60));
}

TEST_F(ReplayProgram, OneStampADayAheadLosesOneImage) {
    std::vector<mrpt::serialization::CSerializable::ConstPtr> objects;
    for (int i = 0; i < 20; ++i)
        objects.push_back(
            testing::image_at(100 + 0.04 * i + (i == 7 ? 86400.0 : 0.0), static_cast<unsigned>(i)));
    const fs::path file = scratch / "ahead.rawlog";
    write_bytes(file, testing::serialized(objects));
    const Outcome outcome = replay(file);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(has(outcome.error, "warning: 1 of 20 images (5.0 %)")) << outcome.error;
    EXPECT_EQ(summary()["read"]["fields"], 19);
    EXPECT_EQ(summary()["rejected"]["time_ahead"], 1);
}

TEST_F(ReplayProgram, ImagesThatAreUpsideDownAreTold) {
    EXPECT_EQ(replay(corridor, {"--set", "camera.rotate=180"}).status, 0);
    const auto warnings = summary()["warnings"];
    const auto is_about_turning = [](const nlohmann::json& warning) {
        const std::string reason = warning["reason"];
        return reason == "view_pitches" || reason == "odometry_turn_reversed" || reason == "fields_lost";
    };
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), is_about_turning)) << warnings;
}

}  // namespace
}  // namespace flownav
