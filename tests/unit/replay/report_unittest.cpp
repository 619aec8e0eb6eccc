#include "flownav/replay/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "flownav/replay/curves.h"
#include "flownav/replay/map_picture.h"
#include "flownav/replay/summary.h"
#include "step_samples.h"

namespace flownav {
namespace {

using testing::sample_drive;

mrpt::maps::COccupancyGridMap2D small_map() {
    mrpt::maps::COccupancyGridMap2D map(-2, 4, -2, 2, 0.1F);
    map.setPos(2.0F, 0.5F, 0.1F);
    map.setPos(1.0F, 0.0F, 0.9F);
    return map;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Report, ShowsFiguresCurvesMapAndSixPictures) {
    const std::string html = report_html(sample_drive(200), small_map());
    for (const Figure& figure : error_figures()) EXPECT_TRUE(has(html, figure.name)) << figure.name;
    for (const auto status : all_field_statuses) EXPECT_TRUE(has(html, to_string(status)));
    EXPECT_TRUE(has(html, "The input was read to its clean end"));
    EXPECT_EQ(count_of(html, "data:image/jpeg"), 6U);
    EXPECT_EQ(count_of(html, "data:image/png"), 1U);
    EXPECT_EQ(count_of(html, "<svg"), charts_of(sample_drive(200)).size() + 1);
    EXPECT_LT(html.size(), 3000000U);
}

TEST(Report, OpensOffline) {
    const std::string html = report_html(sample_drive(50), small_map());
    EXPECT_FALSE(has(html, "http"));
    EXPECT_FALSE(has(html, "<script"));
    EXPECT_FALSE(has(html, "<link"));
}

TEST(Report, HoldsNoTextOfNumbersThatAreNone) {
    Drive drive = sample_drive(50);
    drive.rows[20].omega_radps = std::numeric_limits<double>::quiet_NaN();
    drive.ground_truth_errors->v_bias_percent.reset();
    const std::string html = report_html(drive, small_map());
    EXPECT_FALSE(has(html, ">nan<"));
    EXPECT_FALSE(has(html, ">-nan<"));
    EXPECT_TRUE(has(html, ">-<"));
}

TEST(Report, SaysHowADamagedInputEnded) {
    Drive drive = sample_drive(10);
    drive.end.kind = ReadEnd::Kind::Truncated;
    drive.end.message = "the file ends inside object 11 <here>";
    const std::string html = report_html(drive, small_map());
    EXPECT_TRUE(has(html, "the file ends inside object 11 &lt;here&gt;"));
    EXPECT_FALSE(has(html, "clean end"));
}

TEST(Report, ADriveWithoutAFieldSaysSo) {
    Drive drive;
    drive.input_name = "a&b.rawlog";
    drive.end.kind = ReadEnd::Kind::Corrupt;
    drive.end.message = "this is no rawlog";
    const std::string html = report_html(drive, {});
    EXPECT_TRUE(has(html, "Replay of a&amp;b.rawlog"));
    EXPECT_TRUE(has(html, "No field could be used"));
}

TEST(Report, RejectedInputIsListedWithItsReason) {
    Drive drive = sample_drive(10);
    drive.read.rejected["time_backwards"] = 3;
    EXPECT_TRUE(has(report_html(drive, small_map()), "time_backwards"));
}

TEST(Report, TheSameDriveGivesTheSameBytes) {
    EXPECT_EQ(report_html(sample_drive(60), small_map()), report_html(sample_drive(60), small_map()));
}

TEST(Report, StaysSmallOverLongDrives) {
    Drive drive;
    drive.end.kind = ReadEnd::Kind::Clean;
    FieldRow row = row_of(testing::step_at(1));
    for (int i = 0; i < 200000; ++i) {
        row.timestamp_s = 0.04 * i;
        row.omega_radps = 0.1 * (i % 7);
        row.status = i % 3 == 0 ? FieldStatus::Lost : FieldStatus::Ok;
        row.T_start_robot.x_m = 0.01 * i;
        drive.rows.push_back(row);
    }
    EXPECT_LT(report_html(drive, small_map()).size(), 500000U);
}

TEST(SvgChart, ThinningKeepsTheEndsAndEverySpike) {
    std::vector<Eigen::Vector2d> piece;
    piece.reserve(10000);
    for (int i = 0; i < 10000; ++i) piece.emplace_back(i, i == 4321 ? 100.0 : 0.0);
    const auto few = thinned(piece, 200);
    EXPECT_LE(few.size(), 200U);
    EXPECT_EQ(few.front(), piece.front());
    EXPECT_EQ(few.back(), piece.back());
    EXPECT_EQ(std::count(few.begin(), few.end(), piece[4321]), 1);
    EXPECT_TRUE(std::is_sorted(few.begin(), few.end(), [](auto& a, auto& b) { return a.x() < b.x(); }));
    EXPECT_EQ(thinned(piece, 20000).size(), piece.size());
}

TEST(SvgChart, ConstantAndSingleValuesAreDrawn) {
    Chart chart;
    chart.series = {{"one", "#000", {{{1.0, 5.0}}}, false, 1.8}};
    EXPECT_TRUE(has(svg_chart(chart), "<circle"));
    EXPECT_FALSE(has(svg_chart(chart), "nan"));
    chart.series.front().pieces.clear();
    EXPECT_TRUE(has(svg_chart(chart), "no data"));
}

TEST(SvgChart, TextsCannotBecomeMarkup) {
    EXPECT_EQ(html_text("<a href='x'>\"&"), "&lt;a href=&#39;x&#39;&gt;&quot;&amp;");
}

TEST(MapPicture, ShowsTheKnownPartWithYUp) {
    mrpt::maps::COccupancyGridMap2D map(-5, 5, -5, 5, 0.1F);
    map.setPos(1.0F, 2.0F, 0.01F);
    map.setPos(1.0F, -2.0F, 0.99F);
    const cv::Mat picture = map_picture(map, {});
    ASSERT_FALSE(picture.empty());
    EXPECT_LT(picture.at<cv::Vec3b>(0, 0)[0], 140);
    cv::Mat rows;
    double darkest_y = -1;
    double brightest_y = -1;
    for (int y = 0; y < picture.rows - 45; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            if (picture.at<cv::Vec3b>(y, x)[0] < 10) darkest_y = y;
            if (picture.at<cv::Vec3b>(y, x)[0] > 245) brightest_y = y;
        }
    }
    EXPECT_GE(darkest_y, 0);
    EXPECT_LT(darkest_y, brightest_y) << "the obstacle at y = 2 m stands above the floor at y = -2 m";
    EXPECT_TRUE(map_picture(mrpt::maps::COccupancyGridMap2D(-5, 5, -5, 5, 0.1F), {}).empty());
}

TEST(Summary, HoldsCountsErrorsConfigurationAndOneTimingObject) {
    Drive drive = sample_drive(100);
    drive.read.rejected["time_repeated"] = 2;
    drive.written.cycles = 24;
    Timing timing;
    timing.total_s = 2.0;
    const auto json = nlohmann::json::parse(summary_json(drive, Config{}, timing));
    EXPECT_EQ(json["input"]["file"], "sample.rawlog");
    EXPECT_EQ(json["input"]["end"], "clean");
    EXPECT_EQ(json["rejected"]["time_repeated"], 2);
    EXPECT_EQ(json["written"]["cycles"], 24);
    EXPECT_EQ(json["status"]["ok"], 99);
    EXPECT_EQ(json["status"]["waiting"], 1);
    EXPECT_EQ(json["errors"]["ground_truth"]["fields_compared"], 100);
    EXPECT_NEAR(json["errors"]["ground_truth"]["omega_rms_degps"].get<double>(), 0.0, 1e-6);
    EXPECT_EQ(json["config"]["flow"]["blocks"], "350");
    EXPECT_EQ(json["timing"]["fields_per_s"], 50.0);
}

TEST(Summary, WhatCouldNotBeComputedIsNull) {
    Drive drive = sample_drive(3);
    drive.odometry_errors.reset();
    const auto json = nlohmann::json::parse(summary_json(drive, Config{}, {}));
    EXPECT_TRUE(json["errors"]["odometry"].is_null());
    EXPECT_TRUE(json["errors"]["ground_truth"]["omega_rms_degps"].is_null());
}

TEST(Summary, OnlyTheTimingDependsOnTheRun) {
    const Timing slow = {1.0, 2.0, 3.0, 6.0, 1, "portable"};
    const Timing fast = {0.1, 0.2, 0.3, 0.6, 8, "other"};
    auto a = nlohmann::ordered_json::parse(summary_json(sample_drive(20), Config{}, slow));
    auto b = nlohmann::ordered_json::parse(summary_json(sample_drive(20), Config{}, fast));
    EXPECT_NE(a.dump(), b.dump());
    a.erase("timing");
    b.erase("timing");
    EXPECT_EQ(a.dump(), b.dump());
}

TEST(Summary, AFileNameThatIsNoUtf8IsNoReasonToFail) {
    Drive drive = sample_drive(3);
    drive.input_name = "caf\xe9.rawlog";
    EXPECT_NO_THROW(nlohmann::json::parse(summary_json(drive, Config{}, {})));
}

}  // namespace
}  // namespace flownav
