#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <opencv2/core/mat.hpp>
#include <opencv2/videoio.hpp>
#include <sstream>

#include "flownav/replay/field_source.h"
#include "program.h"

/// MRPT's own rawlog-grabber with the plug-in, and what it writes.
namespace flownav {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CObservationPointCloud;
using testing::Outcome;
using testing::run_program;

const std::string corridor = FLOWNAV_CORRIDOR;
using ByLabel = std::map<std::string, std::vector<CObservation::Ptr>>;

fs::path data_folder() {
    const char* given = std::getenv("FLOWNAV_DATA");
    return given != nullptr ? given : FLOWNAV_DATA;
}

std::string content(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

ByLabel observations_of(const fs::path& rawlog) {
    ByLabel found;
    RawlogReader reader(rawlog);
    while (auto observation = reader.next()) found[observation->sensorLabel].push_back(observation);
    EXPECT_EQ(reader.end().kind, ReadEnd::Kind::Clean) << reader.end().message;
    return found;
}

std::map<std::string, std::size_t> counts(const ByLabel& observations) {
    std::map<std::string, std::size_t> counts;
    for (const auto& [label, list] : observations) counts[label] = list.size();
    return counts;
}

template <class Class>
const Class& as(const CObservation::Ptr& observation) {
    return dynamic_cast<const Class&>(*observation);
}

/// Largest differences between two lists of observations.
struct Differences {
    double time_s = 0.0, omega_radps = 0.0, v_mps = 0.0, position_m = 0.0, heading_rad = 0.0;
    double range_m = 0.0, point_m = 0.0;
    int validity = 0, beams = 0, points = 0;  ///< that do not agree

    void odometry(const CObservationOdometry& a, const CObservationOdometry& b) {
        widen(omega_radps, a.velocityLocal.omega, b.velocityLocal.omega);
        widen(v_mps, a.velocityLocal.vx, b.velocityLocal.vx);
        widen(position_m, a.odometry.x(), b.odometry.x());
        widen(position_m, a.odometry.y(), b.odometry.y());
        widen(heading_rad, a.odometry.phi(), b.odometry.phi());
        if (a.hasVelocities != b.hasVelocities) ++validity;
    }

    void scan(const CObservation2DRangeScan& a, const CObservation2DRangeScan& b) {
        if (a.getScanSize() != b.getScanSize()) ++beams;
        for (std::size_t i = 0; i < std::min(a.getScanSize(), b.getScanSize()); ++i) {
            widen(range_m, a.getScanRange(i), b.getScanRange(i));
            if (a.getScanRangeValidity(i) != b.getScanRangeValidity(i)) ++validity;
        }
    }

    void cloud(const CObservationPointCloud& a, const CObservationPointCloud& b) {
        const auto& left = a.pointcloud->getPointsBufferRef_x();
        const auto& right = b.pointcloud->getPointsBufferRef_x();
        if (left.size() != right.size()) ++points;
        for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i) {
            widen(point_m, left[i], right[i]);
            widen(point_m, a.pointcloud->getPointsBufferRef_y()[i], b.pointcloud->getPointsBufferRef_y()[i]);
            widen(point_m, a.pointcloud->getPointsBufferRef_z()[i], b.pointcloud->getPointsBufferRef_z()[i]);
        }
    }

    static void widen(double& most, double a, double b) { most = std::max(most, std::abs(a - b)); }
};

std::ostream& operator<<(std::ostream& out, const Differences& d) {
    return out << "time " << d.time_s << " s, omega " << d.omega_radps << " rad/s, v " << d.v_mps
               << " m/s, position " << d.position_m << " m, heading " << d.heading_rad << " rad, ranges "
               << d.range_m << " m, points " << d.point_m << " m; of different validity " << d.validity
               << ", size " << d.beams << ", number " << d.points;
}

Differences compared(const ByLabel& grabbed, const ByLabel& replayed) {
    Differences most;
    for (const auto& [label, list] : replayed) {
        const auto& other = grabbed.at(label);
        for (std::size_t i = 0; i < std::min(list.size(), other.size()); ++i) {
            const auto &a = other[i], &b = list[i];
            Differences::widen(most.time_s, mrpt::Clock::toDouble(a->timestamp),
                               mrpt::Clock::toDouble(b->timestamp));
            if (label == "FLOW_SCAN")
                most.scan(as<CObservation2DRangeScan>(a), as<CObservation2DRangeScan>(b));
            if (label == "FLOW_POINTS")
                most.cloud(as<CObservationPointCloud>(a), as<CObservationPointCloud>(b));
            if (has(label, "ODOMETRY"))
                most.odometry(as<CObservationOdometry>(a), as<CObservationOdometry>(b));
        }
    }
    return most;
}

/// Rounding of the time stamps (100 ns) is all that may differ.
void expect_rounding(const Differences& most) {
    std::cout << "most: " << most << '\n';
    EXPECT_LT(most.time_s, 1e-6);
    EXPECT_LT(most.omega_radps, 1e-5);
    EXPECT_LT(most.v_mps, 1e-5);
    EXPECT_LT(most.position_m, 1e-5);
    EXPECT_LT(most.heading_rad, 1e-5);
    EXPECT_LT(most.range_m, 1e-3);
    EXPECT_LT(most.point_m, 1e-3);
    EXPECT_EQ(most.validity + most.beams + most.points, 0);
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
        return run_program("/usr/bin/env", command, folder, testing::Input::Waiting);
    }

    fs::path grabbed_file() const {
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() == ".rawlog" && has(entry.path().filename(), "flow_"))
                return entry.path();
        }
        return {};
    }

    ByLabel grabbed() const { return observations_of(grabbed_file()); }

    ByLabel replayed(const std::string& rawlog, int status = 0) const {
        const Outcome outcome =
            run_program(FLOWNAV_REPLAY, {rawlog, "--output", folder / "replay", "--quiet"}, folder);
        EXPECT_EQ(outcome.status, status) << outcome.error;
        return observations_of(folder / "replay/result.rawlog");
    }

    void expect_the_numbers_of_a_replay(const std::string& rawlog) const {
        const Outcome outcome = grab("grabber_type = rawlog\nrawlog_file = " + rawlog + "\n");
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        const ByLabel grab = grabbed(), replay = replayed(rawlog);
        auto expected = counts(replay);
        auto found = counts(grab);
        found.erase("FLOW_END");  // last of all; rawlog-grabber never writes the last
        EXPECT_EQ(found, expected) << outcome.error;
        for (const auto& [label, count] : found) std::cout << label << ' ' << count << '\n';
        expect_rounding(compared(grab, replay));
    }

    fs::path folder;
};

/// Writes the fields of a rawlog as a lossless video and their camera as an ini; returns the time of the
/// first.
double write_video(const std::string& rawlog, const fs::path& video, const fs::path& ini, double rate_hz) {
    RawlogReader reader(rawlog);
    FieldSource source(reader, CameraConfig{});
    cv::VideoWriter writer;
    double start_s = -1;
    while (const auto event = source.next()) {
        const auto* field = std::get_if<Field>(&*event);
        if (field == nullptr) continue;
        const ImageView& view = field->image;
        if (!writer.isOpened()) {
            start_s = field->timestamp_s;
            writer.open(video.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('F', 'F', 'V', '1'), rate_hz,
                        {view.width_px, view.height_px}, false);
            const CameraModel& c = field->camera;
            std::ofstream(ini) << std::setprecision(17) << "[camera]\nfx_px = " << c.fx_px
                               << "\nfy_px = " << c.fy_px << "\ncx_px = " << c.cx_px
                               << "\ncy_px = " << c.cy_px << "\nheight_m = " << c.mount.height_m
                               << "\nforward_m = " << c.mount.forward_m << "\nleft_m = " << c.mount.left_m
                               << "\npitch_deg = " << c.mount.pitch_rad * 180 / M_PI
                               << "\nroll_deg = " << c.mount.roll_rad * 180 / M_PI
                               << "\nyaw_deg = " << c.mount.yaw_rad * 180 / M_PI << '\n';
        }
        writer.write(cv::Mat(view.height_px, view.width_px, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                             static_cast<std::size_t>(view.stride_bytes)));
    }
    return start_s;
}

TEST_F(RawlogGrabber, WritesTheNumbersOfAReplayOfTheSampleDrive) {
    expect_the_numbers_of_a_replay(corridor);
}

TEST_F(RawlogGrabber, WritesTheNumbersOfAReplayOfTheRecordedScene) {
    const fs::path rawlog = data_folder() / "scenes/field.rawlog";
    if (!fs::exists(rawlog))
        GTEST_SKIP() << "no " << rawlog << "; set FLOWNAV_DATA to the folder with the recordings";
    expect_the_numbers_of_a_replay(rawlog);
}

TEST_F(RawlogGrabber, WritesTheSameNumbersFromAVideo) {
    const double start_s = write_video(corridor, folder / "drive.avi", folder / "camera.ini", 12.5);
    std::ostringstream lines;
    lines << std::setprecision(17)
          << "grabber_type = ffmpeg\nffmpeg_url = " << (folder / "drive.avi").string()
          << "\nflownav_config = " << (folder / "camera.ini").string() << "\nstart_time_s = " << start_s
          << '\n';
    const Outcome outcome = grab(lines.str());
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    ByLabel replay = replayed(corridor);
    replay.erase("ODOMETRY");  // a video has none
    const ByLabel grab = grabbed();
    auto found = counts(grab);
    found.erase("FLOW_END");
    EXPECT_EQ(found, counts(replay)) << outcome.error;
    expect_rounding(compared(grab, replay));
}

TEST_F(RawlogGrabber, WritesWhatRawlogEditReads) {
    grab("grabber_type = rawlog\nrawlog_file = " + corridor + "\n");
    const Outcome info = run_program(FLOWNAV_RAWLOG_EDIT, {"--info", "-i", grabbed_file()}, folder);
    EXPECT_EQ(info.status, 0) << info.error;
    EXPECT_TRUE(has(info.out, "FLOW_ODOMETRY, FLOW_POINTS, FLOW_SCAN, ODOMETRY")) << info.out;
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
