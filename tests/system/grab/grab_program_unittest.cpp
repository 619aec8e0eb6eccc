#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "child.h"
#include "grab_files.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;
using testing::Child;
using testing::Contents;
using testing::contents_of;

class GrabProgram : public ::testing::Test {
  protected:
    /// Adds a test sensor with further keys after its driver and journal.
    void sensor(const std::string& keys) {
        std::ofstream(ini, std::ios::app)
            << "[ONE]\ndriver = CTestSensor\nprocess_rate = 200\njournal = " << journal.string() << '\n'
            << keys << '\n';
    }

    std::unique_ptr<Child> start(const std::vector<std::string>& more = {},
                                 std::uint64_t file_bytes_max = 0) const {
        std::vector<std::string> arguments = {ini, "--output", rawlog, "--plugin", FLOWNAV_TEST_SENSOR};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return std::make_unique<Child>(FLOWNAV_GRAB, arguments, folder / "log", file_bytes_max);
    }

    std::string log() const {
        std::ostringstream text;
        text << std::ifstream(folder / "log").rdbuf();
        return text.str();
    }

    void expect_said(const std::string& part) const {
        EXPECT_NE(log().find(part), std::string::npos) << part << " is missing in\n" << log();
    }

    /// Expects every noted observation in the recording, which must end cleanly.
    void expect_complete() const {
        const Contents contents = contents_of(rawlog);
        EXPECT_EQ(contents.end.kind, io::ReadEnd::Kind::Clean) << contents.end.message;
        EXPECT_TRUE(testing::missing(testing::journal_of(journal), contents.sightings).empty());
    }

    void wait_for_observations(std::size_t count, Child& child) const {
        while (child.running() && testing::journal_of(journal).size() < count)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }

    const fs::path folder = testing::grab_folder();
    const fs::path ini = folder / "grab.ini";
    const fs::path journal = folder / "journal";
    const fs::path rawlog = folder / "drive.rawlog";
};

// ---- regular ends

TEST_F(GrabProgram, EndsAfterItsDuration) {
    sensor("");
    EXPECT_EQ(start({"--duration", "0.3"})->wait(), 0) << log();
    expect_complete();
    EXPECT_GT(contents_of(rawlog).sightings.size(), 10U);
    expect_said("(ONE ");
}

TEST_F(GrabProgram, ASourceThatIsReadToItsEndIsNoFailure) {
    sensor("turns = 20\nthen = end");
    EXPECT_EQ(start({"--quiet"})->wait(), 0);
    EXPECT_EQ(log(), "");
    expect_complete();
    EXPECT_EQ(contents_of(rawlog).sightings.size(), 20U);
}

TEST_F(GrabProgram, TheFlowSensorNeedsNoPlugin) {
    testing::write_text(ini, std::string("[global]\ntime_between_launches = 10\n[FLOW]\ndriver = "
                                         "CFlowObstacleSensor\nprocess_rate = 500\ngrabber_type = "
                                         "rawlog\nrawlog_file = ") +
                                 FLOWNAV_CORRIDOR + "\n");
    EXPECT_EQ(Child(FLOWNAV_GRAB, {ini, "--output", rawlog}, folder / "log").wait(), 0) << log();
    const Contents contents = contents_of(rawlog);
    EXPECT_EQ(contents.end.kind, io::ReadEnd::Kind::Clean) << contents.end.message;
    const auto count = [&](const std::string& label) {
        return std::count_if(contents.sightings.begin(), contents.sightings.end(),
                             [&](const testing::Sighting& s) { return s.first == label; });
    };
    EXPECT_EQ(count("FLOW_ODOMETRY"), 60);
    EXPECT_EQ(count("ODOMETRY"), 60);
    EXPECT_GT(count("FLOW_SCAN"), 10);
    EXPECT_EQ(count("FLOW_SCAN"), count("FLOW_POINTS"));
}

TEST_F(GrabProgram, SensorsAreRecordedInTheOrderOfTime) {
    testing::write_text(ini, testing::two_sensors(journal));
    sensor("lag_s = 0.03");
    EXPECT_EQ(start({"--duration", "0.8"})->wait(), 0) << log();
    expect_complete();
    const Contents contents = contents_of(rawlog);
    std::vector<std::int64_t> times;
    for (const auto& [label, time] : contents.sightings) times.push_back(time);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
}

TEST_F(GrabProgram, SectionsThatAreIgnoredAreNotEvenConfigured) {
    sensor("turns = 3\nthen = end");
    std::ofstream(ini, std::ios::app) << "[TWO]\nrawlog-grabber-ignore = true\ndriver = CNoSuchThing\n";
    EXPECT_EQ(start()->wait(), 0) << log();
    expect_complete();
}

// ---- rotation

TEST_F(GrabProgram, AFullFileIsFollowedByTheNextAndEachIsReadable) {
    testing::write_text(ini, testing::two_sensors(journal));
    EXPECT_EQ(start({"--duration", "1.2", "--max-size", "1"})->wait(), 0) << log();
    const auto parts = testing::parts_of(rawlog);
    ASSERT_GE(parts.size(), 3U) << log();
    std::vector<testing::Sighting> all;
    for (const fs::path& part : parts) {
        const Contents contents = contents_of(part);
        EXPECT_EQ(contents.end.kind, io::ReadEnd::Kind::Clean) << contents.end.message;
        EXPECT_FALSE(contents.sightings.empty()) << part;
        EXPECT_LE(fs::file_size(part), 1000000U) << part;
        all.insert(all.end(), contents.sightings.begin(), contents.sightings.end());
        expect_said(part.string());
    }
    EXPECT_TRUE(testing::missing(testing::journal_of(journal), all).empty());
    EXPECT_EQ(all.size(), testing::journal_of(journal).size());
}

TEST_F(GrabProgram, ExistingRecordingsAreReplacedOnlyWhenAsked) {
    sensor("turns = 3\nthen = end");
    testing::write_text(folder / "drive_002.rawlog", "precious");
    EXPECT_EQ(start()->wait(), 1);
    expect_said("drive_002.rawlog exists");
    EXPECT_FALSE(fs::exists(rawlog));
    testing::write_text(rawlog, "precious");
    EXPECT_EQ(start()->wait(), 1);
    EXPECT_EQ(fs::file_size(rawlog), 8U);
    testing::write_text(folder / "drive_test.rawlog", "not part of it");
    EXPECT_EQ(start({"--overwrite"})->wait(), 0) << log();
    expect_complete();
    EXPECT_FALSE(fs::exists(folder / "drive_002.rawlog"));
    EXPECT_TRUE(fs::exists(folder / "drive_test.rawlog"));
}

// ---- sensors that fail

TEST_F(GrabProgram, AnExceptionOfASensorEndsWithTwoAndKeepsAll) {
    sensor("turns = 20\nthen = throw");
    EXPECT_EQ(start()->wait(), 2);
    expect_said("sensor ONE: the cable was pulled");
    expect_complete();
    EXPECT_EQ(contents_of(rawlog).sightings.size(), 21U);
}

TEST_F(GrabProgram, AnErrorStateOfASensorEndsWithTwoAndKeepsAll) {
    sensor("turns = 20\nthen = error");
    EXPECT_EQ(start()->wait(), 2);
    expect_said("sensor ONE: ");
    expect_complete();
}

TEST_F(GrabProgram, ASensorThatCannotBeOpenedEndsWithTwo) {
    sensor("then = no_device");
    EXPECT_EQ(start()->wait(), 2);
    expect_said("sensor ONE: no such device");
}

TEST_F(GrabProgram, ASensorThatFallsSilentEndsWithTwoAndKeepsAll) {
    sensor("turns = 20\nthen = silence");
    EXPECT_EQ(start({"--silence", "0.5"})->wait(), 2);
    expect_said("sensor ONE: no observation for 0.5 s");
    expect_complete();
}

TEST_F(GrabProgram, ASensorThatHangsEndsWithTwoAndKeepsAll) {
    testing::write_text(ini, testing::two_sensors(journal));
    sensor("turns = 20\nthen = hang");
    EXPECT_EQ(start({"--silence", "0.5"})->wait(), 2);
    expect_said("sensor ONE: no observation for 0.5 s");
    expect_complete();
}

// ---- disks that fail

TEST_F(GrabProgram, ADiskThatFillsUpEndsWithThreeAndAReadableRecording) {
    testing::write_text(ini, testing::two_sensors(journal));
    EXPECT_EQ(start({}, 1500000)->wait(), 3);
    expect_said("cannot write " + rawlog.string() + ": File too large");
    const Contents contents = contents_of(rawlog);
    EXPECT_EQ(contents.end.kind, io::ReadEnd::Kind::Clean) << contents.end.message;
    EXPECT_GT(contents.sightings.size(), 10U);
}

TEST_F(GrabProgram, NoSpaceAtAllEndsWithThree) {
    sensor("");
    EXPECT_EQ(
        Child(FLOWNAV_GRAB, {ini, "--output", "/dev/full", "--plugin", FLOWNAV_TEST_SENSOR}, folder / "log")
            .wait(),
        3);
    expect_said("cannot write /dev/full: No space left on device");
    EXPECT_EQ(
        Child(FLOWNAV_GRAB, {ini, "--output", folder / "none/x.rawlog", "--plugin", FLOWNAV_TEST_SENSOR},
              folder / "log")
            .wait(),
        3);
    expect_said("No such file or directory");
}

TEST_F(GrabProgram, WhatADiskTooSlowCostsIsReported) {
    testing::write_text(ini, testing::two_sensors(journal));
    EXPECT_EQ(start({"--duration", "0.5", "--queue", "0.001"})->wait(), 4);
    expect_said("the disk was too slow: ");
    expect_said(" observations of CAMERA");
    EXPECT_EQ(contents_of(rawlog).end.kind, io::ReadEnd::Kind::Clean);
}

// ---- odd surroundings

TEST_F(GrabProgram, ClosedStandardStreamsDoNoHarm) {
    sensor("turns = 20\nthen = throw");
    const std::string command = R"(exec "$0" "$@" <&- >&- 2>&-)";
    Child child("/bin/sh",
                {"-c", command, FLOWNAV_GRAB, ini, "--output", rawlog, "--plugin", FLOWNAV_TEST_SENSOR},
                folder / "log");
    EXPECT_EQ(child.wait(), 2);
    expect_complete();
}

// ---- bad usage

TEST_F(GrabProgram, BadConfigurationEndsWithOneAndWritesNothing) {
    const auto refused = [&](const std::string& text, const std::string& said) {
        testing::write_text(ini, text);
        EXPECT_EQ(start()->wait(), 1) << text;
        expect_said(said);
        EXPECT_FALSE(fs::exists(rawlog)) << text;
    };
    refused("", "names no sensor");
    refused("[global]\nrawlog_GZ_compress_level = 10\n", "(0 .. 9)");
    refused("[ONE]\nprocess_rate = 10\n", "[ONE]: needs the key driver");
    refused("[ONE]\ndriver = CNoSuchThing\nprocess_rate = 10\n", "[ONE]: driver = CNoSuchThing is not known");
    refused("[ONE]\ndriver = CTestSensor\n", "process_rate");
    refused("[ONE]\ndriver = CTestSensor\nprocess_rate = 0\n", "[ONE]: process_rate must be above 0");
    refused("[ONE]\ndriver = CTestSensor\nprocess_rate = 9\nrefuse = true\n", "[ONE]: the key refuse is set");
    fs::remove(ini);
    EXPECT_EQ(start()->wait(), 1);
    expect_said("cannot read the configuration " + ini.string());
}

TEST_F(GrabProgram, BadArgumentsEndWithOneAndWriteNothing) {
    sensor("");
    for (const std::vector<std::string>& more : {std::vector<std::string>{"--max-size", "0"},
                                                 {"--max-size", "nan"},
                                                 {"--duration", "-1"},
                                                 {"--queue", "0"},
                                                 {"--silence", "x"},
                                                 {"--nonsense"},
                                                 {"--plugin", "none.so"}}) {
        EXPECT_EQ(start(more)->wait(), 1) << more.front();
        EXPECT_FALSE(fs::exists(rawlog)) << more.front();
        expect_said("flownav-grab: ");
    }
}

// ---- other programs read the recording

TEST_F(GrabProgram, AGrowingRecordingCanBeReadAtAnyMoment) {
    testing::write_text(ini, testing::two_sensors(journal));
    const auto child = start({"--duration", "5"});
    std::size_t before = 0;
    for (std::size_t observations = 60; observations <= 180; observations += 60) {
        wait_for_observations(observations, *child);
        const Contents contents = contents_of(rawlog);
        EXPECT_TRUE(contents.end.kind == io::ReadEnd::Kind::Clean ||
                    contents.end.kind == io::ReadEnd::Kind::Truncated)
            << contents.end.message;
        EXPECT_GT(contents.sightings.size(), before);
        before = contents.sightings.size();
    }
    child->signal(SIGTERM);
    EXPECT_EQ(child->wait(), 0);
    expect_complete();
}

TEST_F(GrabProgram, RawlogEditReadsWhatAKilledRecordingHolds) {
    const bool there = std::string(FLOWNAV_RAWLOG_EDIT).find("NOTFOUND") == std::string::npos;
    if (!there) GTEST_SKIP() << "no rawlog-edit";
    testing::write_text(ini, testing::two_sensors(journal));
    const auto child = start();
    wait_for_observations(150, *child);
    child->signal(SIGKILL);
    EXPECT_EQ(child->wait(), -SIGKILL);
    const Contents contents = contents_of(rawlog);
    // rawlog-edit misreads files when its standard input is closed.
    const std::string command = R"(exec "$0" "$@" </dev/null)";
    EXPECT_EQ(
        Child("/bin/sh", {"-c", command, FLOWNAV_RAWLOG_EDIT, "-i", rawlog, "--info"}, folder / "log").wait(),
        0);
    std::istringstream lines(log());
    std::string said;
    for (std::string line; std::getline(lines, line);) {
        const bool found = line.find("Overall number of objects") != std::string::npos;
        if (found) said = line.substr(line.find(':') + 2);
    }
    EXPECT_EQ(said, std::to_string(contents.sightings.size())) << log();
}

}  // namespace
}  // namespace flownav
