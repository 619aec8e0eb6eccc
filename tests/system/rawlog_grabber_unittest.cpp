#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

#include "compare_rawlogs.h"
#include "drive_video.h"
#include "program.h"

/// MRPT's own rawlog-grabber with the plug-in, and its recordings.
namespace flownav {
namespace {

using namespace flownav::testing;
namespace fs = std::filesystem;

const std::string corridor = FLOWNAV_CORRIDOR;

/// The recorded scene of the optional test data.
fs::path scene() {
    const char* given = std::getenv("FLOWNAV_DATA");
    return fs::path(given != nullptr ? given : FLOWNAV_DATA) / "scenes/field.rawlog";
}

std::string content(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Allows only differences by the rounding of the time stamps (100 ns). `flips`: so many beams may end
/// elsewhere, because a contact has one vote more or less than it needs.
void expect_rounding(const Differences& most, int flips) {
    std::cout << "most: " << most << '\n';
    EXPECT_LT(most.time_s, 1e-6);
    EXPECT_LT(most.omega_radps, 1e-5);
    EXPECT_LT(most.v_mps, 1e-5);
    EXPECT_LT(most.position_m, 1e-5);
    EXPECT_LT(most.heading_rad, 1e-5);
    EXPECT_LT(most.range_m, 1e-3);
    EXPECT_LT(most.point_m, 1e-3);
    EXPECT_EQ(most.validity + most.beams + most.points, 0);
    EXPECT_LE(most.other_beams, flips);
}

class RawlogGrabber : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder = fs::path(::testing::TempDir()) / "flownav_rawlog_grabber" / test->name();
        fs::remove_all(folder);
        fs::create_directories(folder);
    }

    /// Runs share/grabber.ini with the source of the images replaced by these lines.
    Outcome grab(const std::string& source_lines) const {
        const std::string sample = content(FLOWNAV_GRABBER_INI);
        const auto from = sample.find("\ngrabber_type = ") + 1;
        const auto to = sample.find("\n# A camera") + 1;
        EXPECT_LT(from, to);
        std::string ini = sample.substr(0, from) + source_lines + sample.substr(to);
        const std::string prefix = "rawlog_prefix = ./flow";
        EXPECT_TRUE(has(ini, prefix));
        ini.replace(ini.find(prefix), prefix.size(), "rawlog_prefix = " + (folder / "flow").string());
        std::ofstream(folder / "grabber.ini") << ini;
        std::vector<std::string> command = {"ASAN_OPTIONS=detect_leaks=0"};
        if (*FLOWNAV_PRELOAD != '\0') command.emplace_back("LD_PRELOAD=" FLOWNAV_PRELOAD);
        command.insert(command.end(), {FLOWNAV_RAWLOG_GRABBER, "-p", FLOWNAV_PLUGIN, folder / "grabber.ini"});
        return run_program("/usr/bin/env", command, folder, Input::Waiting);
    }

    fs::path grabbed_file() const {
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() == ".rawlog" && has(entry.path().filename(), "flow_"))
                return entry.path();
        }
        return {};
    }

    ByLabel grabbed() const { return observations_of(grabbed_file()); }

    ByLabel replayed(const std::string& rawlog, int status = 0,
                     const std::vector<std::string>& options = {}) const {
        std::vector<std::string> arguments = {rawlog, "--output", folder / "replay", "--quiet"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = run_program(FLOWNAV_REPLAY, arguments, folder);
        EXPECT_EQ(outcome.status, status) << outcome.error;
        return observations_of(folder / "replay/result.rawlog");
    }

    void expect_the_numbers_of_a_replay(const std::string& rawlog) const {
        const Outcome outcome = grab("grabber_type = rawlog\nrawlog_file = " + rawlog + "\n");
        expect_same(outcome, replayed(rawlog));
    }

    void expect_the_numbers_of_a_replay_from_a_video(const std::string& rawlog) const {
        const Outcome outcome = grab(make_drive_video(rawlog, folder));
        // A video has no odometry.
        ByLabel replay = replayed(rawlog, 0, {"--set", "motion.wheels=off"});
        replay.erase("ODOMETRY");
        expect_same(outcome, replay, 20);
    }

    void expect_same(const Outcome& outcome, const ByLabel& replay, int flips = 0) const {
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        const ByLabel grab = grabbed();
        auto found = counts(grab);
        found.erase("FLOW_END");  // the last observation; rawlog-grabber never writes the last one
        ASSERT_EQ(found, counts(replay)) << outcome.error;
        for (const auto& [label, count] : found) std::cout << label << ' ' << count << '\n';
        expect_rounding(compared(grab, replay), flips);
    }

    fs::path folder;
};

TEST_F(RawlogGrabber, WritesTheNumbersOfAReplayOfTheSampleDrive) {
    expect_the_numbers_of_a_replay(corridor);
}

TEST_F(RawlogGrabber, WritesTheNumbersOfAReplayOfTheRecordedScene) {
    if (!fs::exists(scene()))
        GTEST_SKIP() << "no " << scene() << "; set FLOWNAV_DATA to the folder with the recordings";
    expect_the_numbers_of_a_replay(scene());
}

TEST_F(RawlogGrabber, WritesTheSameNumbersFromAVideoOfTheSampleDrive) {
    expect_the_numbers_of_a_replay_from_a_video(corridor);
}

TEST_F(RawlogGrabber, WritesTheSameNumbersFromAWovenVideoOfTheRecordedScene) {
    if (!fs::exists(scene()))
        GTEST_SKIP() << "no " << scene() << "; set FLOWNAV_DATA to the folder with the recordings";
    expect_the_numbers_of_a_replay_from_a_video(scene());
}

TEST_F(RawlogGrabber, WritesWhatRawlogEditReads) {
    grab("grabber_type = rawlog\nrawlog_file = " + corridor + "\n");
    const Outcome info = run_program(FLOWNAV_RAWLOG_EDIT, {"--info", "-i", grabbed_file()}, folder);
    EXPECT_EQ(info.status, 0) << info.error;
    EXPECT_TRUE(has(info.out, "FLOW_ODOMETRY, FLOW_POINTS, FLOW_POSE, FLOW_SCAN, ODOMETRY")) << info.out;
}

TEST_F(RawlogGrabber, KeepsWhatADamagedRawlogHeldAndSaysWhy) {
    const fs::path damaged = folder / "damaged.rawlog";
    fs::copy_file(corridor, damaged);
    fs::resize_file(damaged, fs::file_size(corridor) / 2);
    const Outcome outcome = grab("grabber_type = rawlog\nrawlog_file = " + damaged.string() + "\n");
    EXPECT_TRUE(has(outcome.error, "damaged.rawlog")) << outcome.error;
    auto found = counts(grabbed());
    found.erase("FLOW_END");
    EXPECT_EQ(found, counts(replayed(damaged, 2)));
    EXPECT_GT(found.at("FLOW_ODOMETRY"), 20U);
}

TEST_F(RawlogGrabber, EndsWithAMessageWhenThereIsNothingToOpen) {
    const auto error = [this](const std::string& lines) {
        const Outcome outcome = grab(lines);
        EXPECT_EQ(outcome.status, 0) << "rawlog-grabber knows no other";
        return outcome.error;
    };
    EXPECT_TRUE(has(error("grabber_type = opencv\ncv_camera_index = 99\n"), "cannot be opened"));
    EXPECT_TRUE(has(error("grabber_type = ffmpeg\nffmpeg_url = none.avi\n"), "none.avi: no such file"));
    EXPECT_TRUE(
        has(error("grabber_type = rawlog\nrawlog_file = none.rawlog\n"), "none.rawlog: no such file"));
    EXPECT_TRUE(has(error("grabber_type = rawlog\nrawlog_fill = x\n"), "rawlog_file"));
}

}  // namespace
}  // namespace flownav
