#include "flownav/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "flownav/evaluation/summary.h"
#include "flownav/report/map_picture.h"
#include "step_samples.h"

namespace flownav::report {
namespace {

using nlohmann::json;
using testing::sample_drive;

mrpt::maps::COccupancyGridMap2D small_map() {
    mrpt::maps::COccupancyGridMap2D map(-2, 4, -2, 2, 0.1F);
    map.setPos(2.0F, 0.5F, 0.1F);
    map.setPos(1.0F, 0.0F, 0.9F);
    return map;
}

std::string report_of(const evaluation::Drive& drive, const evaluation::Timing* timing = nullptr) {
    return report_html(drive, testing::sample_thumbnail_strip(60), small_map(), config::Config{}, timing);
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The JSON data of the page's script.
json data_of(const std::string& html) {
    const std::string begin = "id='data'>";
    const auto from = html.find(begin) + begin.size();
    return json::parse(html.substr(from, html.find("</script>", from) - from));
}

json chart_of(const json& data, const std::string& id) {
    for (const json& chart : data["charts"])
        if (chart["id"] == id) return chart;
    return nullptr;
}

json series_of(const json& chart, const std::string& name) {
    for (const json& series : chart["series"])
        if (series["name"] == name) return series["values"];
    return nullptr;
}

/// Collects the keys of all figures in a part of the summary, such as "read.fields".
void collect_keys(const json& part, const std::string& path, std::vector<std::string>& keys) {
    for (const auto& [name, value] : part.items()) {
        const std::string key = path.empty() ? name : std::string(path).append(".").append(name);
        if (value.is_object()) collect_keys(value, key, keys);
        if (value.is_primitive()) keys.push_back(key);
    }
}

TEST(Report, EveryFigureOfTheSummaryIsExplained) {
    evaluation::Drive drive = sample_drive(60);
    drive.read.rejected["time_backwards"] = 3;
    drive.read.warnings["calibration_changed"] = 1;
    drive.read.observations["CObservationImage CAMERA1"] = 60;
    drive.written.result_rawlog["FLOW_SCAN"] = 14;
    const std::string html = report_of(drive);
    json summary = json::parse(evaluation::summary_json(drive, config::Config{}, {}));
    for (const char* not_a_figure : {"program", "version", "input", "timing"}) summary.erase(not_a_figure);
    summary["errors"] = summary["errors"]["odometry"];
    std::vector<std::string> keys;
    collect_keys(summary, "", keys);
    EXPECT_GT(keys.size(), 80U);
    for (const std::string& key : keys) EXPECT_TRUE(has(html, "data-key='" + key + "'")) << key;
    EXPECT_FALSE(has(html, "not described"));
    EXPECT_TRUE(has(html, "image: is older than the one before it"));
}

TEST(Report, EveryReasonHasWords) {
    evaluation::Drive drive = sample_drive(10);
    for (const char* reason :
         {"time_invalid", "time_repeated", "time_backwards", "image_missing", "image_unreadable",
          "image_empty", "image_not_8bit", "odometry_time_repeated", "ground_truth_not_finite"})
        drive.read.rejected[reason] = 1;
    for (const char* warning : {"image_size_changed", "calibration_changed", "calibration_of_another_size"})
        drive.read.warnings[warning] = 1;
    const std::string html = report_of(drive);
    for (const auto& counts : {drive.read.rejected, drive.read.warnings}) {
        for (const auto& [reason, count] : counts) {
            EXPECT_FALSE(has(html, "<td>" + reason + "</td></tr>"))
                << "said in its own words only: " << reason;
        }
    }
    EXPECT_TRUE(has(html, "pose of the odometry: has the same time stamp as the one before"));
}

TEST(Report, ChartsHoldFlowOdometryAndTruthOverTime) {
    const json data = data_of(report_of(sample_drive(60)));
    for (const char* id : {"turn", "speed", "heading"}) {
        const json chart = chart_of(data, id);
        ASSERT_EQ(chart["t"].size(), 60U) << id;
        EXPECT_EQ(chart["t"][25], 1.0);
        EXPECT_FALSE(chart["unit"].get<std::string>().empty());
        for (const char* name : {"flow", "odometry", "ground truth"})
            EXPECT_EQ(series_of(chart, name).size(), 60U) << id << ' ' << name;
    }
    EXPECT_NEAR(series_of(chart_of(data, "turn"), "flow")[30].get<double>(), 11.459, 1e-3);
    EXPECT_NEAR(series_of(chart_of(data, "turn"), "ground truth")[30].get<double>(), 11.459, 2e-3);
    EXPECT_NEAR(series_of(chart_of(data, "speed"), "flow")[4].get<double>(), 0.4, 1e-3);
    EXPECT_TRUE(series_of(chart_of(data, "speed"), "flow")[5].is_null()) << "measured at ends of cycles only";
    const json labels = chart_of(data, "labels");
    EXPECT_EQ(labels["t"][1], 0.16) << "once a cycle";
    EXPECT_EQ(series_of(labels, "obstacle")[1], 1);
    EXPECT_EQ(series_of(labels, "obstacle")[0], false);
    EXPECT_EQ(series_of(chart_of(data, "distance"), "flow")[59], 0);
    EXPECT_EQ(data["tracks"].size(), 3U);
    EXPECT_EQ(data["pictures"].size(), count_of(report_of(sample_drive(60)), "<figure><img"));
}

TEST(Report, ChartsHoldTheStripsOfEveryScanAndTheFitOfTheFloor) {
    evaluation::Drive drive = sample_drive(21);
    drive.rows[8].contacts.gate = ContactGate::NoTravel;
    const json data = data_of(report_of(drive));
    const json chart = chart_of(data, "contacts");
    EXPECT_EQ(chart["t"], json({0, 0.16, 0.32, 0.48, 0.64, 0.8}));
    EXPECT_EQ(series_of(chart, "free"), json({false, 2, false, 2, 2, 2}));
    EXPECT_EQ(series_of(chart, "wall")[1], 1);
    EXPECT_EQ(series_of(chart, "unknown")[1], 1);
    EXPECT_EQ(series_of(chart_of(data, "floor"), "floor that fits")[1], 0.81);
}

TEST(Report, ADriveWithoutAScanHasNoChartOfThem) {
    evaluation::Drive drive = sample_drive(21);
    for (evaluation::FieldRow& row : drive.rows) row.contacts = {};
    EXPECT_TRUE(chart_of(data_of(report_of(drive)), "contacts").is_null());
}

TEST(Report, PicturesHoldTheirContactsWithTheColoursOfTheCauses) {
    const json picture = data_of(report_of(sample_drive(60)))["pictures"][0];
    ASSERT_EQ(picture["contacts"].size(), 3U);
    EXPECT_EQ(picture["contacts"][0][4], "#d55e00") << "votes, on the left";
    EXPECT_EQ(picture["contacts"][1][4], "#56b4e9") << "a wall, on the right";
    EXPECT_GT(picture["contacts"][0][1].get<double>(), picture["contacts"][1][1].get<double>());
    EXPECT_EQ(picture["strips"], json({2, 1, 1, 1, 0, 1})) << "floor, contact, wall, drop, blocks, unknown";
    EXPECT_EQ(count_of(report_of(sample_drive(60)), "data-key='strip."), 6U);
}

TEST(Report, WhatWasNotMeasuredIsAGap) {
    evaluation::Drive drive = sample_drive(50);
    drive.rows[21].status = FieldStatus::Lost;
    drive.rows[30].omega_radps = std::numeric_limits<double>::quiet_NaN();
    const json data = data_of(report_of(drive));
    const json turn = series_of(chart_of(data, "turn"), "flow");
    EXPECT_EQ(turn[21], false);
    EXPECT_TRUE(turn[30].is_null());
    EXPECT_EQ(series_of(chart_of(data, "speed"), "flow")[21], false);
    EXPECT_EQ(data["status"]["runs"][2], json({0.84, 0.88, 2}));
}

TEST(Report, OpensOffline) {
    const std::string html = report_of(sample_drive(50));
    EXPECT_FALSE(has(html, "http"));
    EXPECT_FALSE(has(html, "sourceMappingURL"));
    EXPECT_EQ(count_of(html, " src='"), count_of(html, " src='data:"));
    EXPECT_TRUE(has(html, "Permission is hereby granted")) << "the licence of dygraphs asks for it";
    EXPECT_TRUE(has(html, "<noscript>"));
}

TEST(Report, HoldsNoTextOfNumbersThatAreNone) {
    evaluation::Drive drive = sample_drive(50);
    drive.ground_truth_errors->v_bias_percent.reset();
    const std::string html = report_of(drive);
    EXPECT_FALSE(has(html, ">nan<"));
    EXPECT_FALSE(has(html, ">-nan<"));
    EXPECT_TRUE(has(html, ">-<"));
}

TEST(Report, SaysHowADamagedInputEnded) {
    evaluation::Drive drive = sample_drive(10);
    drive.end.kind = io::ReadEnd::Kind::Truncated;
    drive.end.message = "the file ends inside object 11 <here>";
    const std::string html = report_of(drive);
    EXPECT_TRUE(has(html, "the file ends inside object 11 &lt;here&gt;"));
    EXPECT_FALSE(has(html, "clean end"));
}

TEST(Report, ADriveWithoutAFieldSaysSo) {
    evaluation::Drive drive;
    drive.input_name = "a&b.rawlog";
    drive.end.kind = io::ReadEnd::Kind::Corrupt;
    drive.end.message = "this is no rawlog";
    const std::string html = report_html(drive, ThumbnailStrip(), {}, config::Config{});
    EXPECT_TRUE(has(html, "Replay of a&amp;b.rawlog"));
    EXPECT_TRUE(has(html, "No field could be used"));
}

TEST(Report, SaysWhenTheSpeedOrTheMotionIsMostlyNotKnown) {
    evaluation::Drive drive = sample_drive(50);
    EXPECT_FALSE(has(report_of(drive), "class='bad'>The speed was not measured"));
    for (evaluation::FieldRow& row : drive.rows) row.v_measured = false;
    EXPECT_TRUE(has(report_of(drive), "class='bad'>The speed was not measured"));
    EXPECT_FALSE(has(report_of(drive), "class='bad'>The motion is not known"));
    for (evaluation::FieldRow& row : drive.rows) row.status = FieldStatus::NoTexture;
    EXPECT_TRUE(has(report_of(drive), "class='bad'>The motion is not known"));
}

TEST(Report, NamesCannotBecomeMarkup) {
    const std::string evil = "</script><script>alert(1)</script><!--<b x='\"&.rawlog";
    evaluation::Drive drive = sample_drive(10);
    const std::size_t scripts = count_of(report_of(drive), "<script");
    drive.input_name = drive.stop_reason = evil;
    drive.camera_check.warnings = {evil};
    drive.read.rejected[evil] = drive.read.warnings[evil] = drive.read.observations[evil] = 1;
    drive.written.result_rawlog[evil] = 1;
    config::Config config;
    config.camera.camera_label = evil;
    const std::string html = report_html(drive, testing::sample_thumbnail_strip(10), small_map(), config);
    EXPECT_EQ(count_of(html, "<script"), scripts);
    EXPECT_EQ(count_of(html, "</script"), scripts);
    EXPECT_FALSE(has(html, "<b x"));
    EXPECT_FALSE(has(html, "<!--"));
    EXPECT_EQ(data_of(html)["input"], evil);
}

TEST(Report, ANameThatIsNoUtf8IsNoReasonToFail) {
    evaluation::Drive drive = sample_drive(3);
    drive.input_name = "caf\xe9.rawlog";
    EXPECT_NO_THROW(data_of(report_of(drive)));
}

TEST(Report, TheSameDriveGivesTheSameBytes) {
    EXPECT_EQ(report_of(sample_drive(60)), report_of(sample_drive(60)));
}

/// A drive of two hours with occasional faults.
evaluation::Drive long_drive() {
    evaluation::Drive drive;
    drive.end.kind = io::ReadEnd::Kind::Clean;
    evaluation::FieldRow row = evaluation::row_of(testing::step_at(1));
    for (int i = 0; i < 180000; ++i) {
        row.timestamp_s = 0.04 * i;
        row.omega_radps = i == 123456 ? -1.0 : 0.001 * (i % 7);
        row.status = i % 30000 == 29999 ? FieldStatus::Lost : FieldStatus::Ok;
        row.T_start_robot.x_m = 0.01 * i;
        drive.rows.push_back(row);
    }
    return drive;
}

TEST(Report, LongDrivesAreThinnedOutWithoutLosingASpikeOrAGap) {
    const std::string html = report_of(long_drive());
    EXPECT_LT(html.size(), 2500000U);
    const json data = data_of(html);
    for (const json& chart : data["charts"]) {
        EXPECT_LE(chart["t"].size(), 5002U) << chart["id"];
        EXPECT_TRUE(std::is_sorted(chart["t"].begin(), chart["t"].end()));
        EXPECT_EQ(chart["t"].back(), 7199.96);
    }
    const json turn = series_of(chart_of(data, "turn"), "flow");
    EXPECT_EQ(std::count(turn.begin(), turn.end(), json(-57.296)), 1);
    EXPECT_EQ(std::count(turn.begin(), turn.end(), json(false)), 6);
    const json& runs = data["status"]["runs"];
    EXPECT_EQ(std::count_if(runs.begin(), runs.end(), [](const json& run) { return run[2] == 2; }), 6);
    EXPECT_EQ(data["tracks"][0]["t"].back(), 7199.96);
}

TEST(Report, TheMapLiesWhereItBelongs) {
    const json map = data_of(report_of(sample_drive(50)))["map"];
    EXPECT_TRUE(has(map["png"], "data:image/png;base64,"));
    EXPECT_NEAR(map["cell"].get<double>(), 0.1, 1e-6);
    EXPECT_LT(map["x"].get<double>(), 0.0);
    EXPECT_GT(map["x"].get<double>() + map["columns"].get<double>() * 0.1, 2.0);
    EXPECT_TRUE(
        data_of(report_html(sample_drive(5), ThumbnailStrip(), {}, config::Config{}))["map"].is_null());
}

TEST(MapPicture, ShowsTheKnownPartWithYUp) {
    mrpt::maps::COccupancyGridMap2D map(-5, 5, -5, 5, 0.1F);
    map.setPos(1.0F, 2.0F, 0.01F);
    map.setPos(1.0F, -2.0F, 0.99F);
    const MapPicture picture = map_picture(map, {});
    ASSERT_FALSE(picture.cells.empty());
    const auto grey_at = [&](double x_m, double y_m) {
        const int column = static_cast<int>((x_m - picture.left_m) / picture.cell_m);
        const int row = static_cast<int>((y_m - picture.bottom_m) / picture.cell_m);
        return picture.cells.at<std::uint8_t>(picture.cells.rows - 1 - row, column);
    };
    EXPECT_LT(grey_at(1.03, 2.03), 10);
    EXPECT_GT(grey_at(1.03, -1.97), 245);
    EXPECT_NEAR(grey_at(1.03, 0.03), 128, 2);
    EXPECT_TRUE(map_picture(mrpt::maps::COccupancyGridMap2D(-5, 5, -5, 5, 0.1F), {}).cells.empty());
}

TEST(MapPicture, AVeryLargeMapComesWithLargerCells) {
    mrpt::maps::COccupancyGridMap2D map(0, 500, 0, 10, 0.1F);
    for (int x_dm = 10; x_dm < 4990; ++x_dm) map.setPos(0.1F * static_cast<float>(x_dm), 5.0F, 0.9F);
    const MapPicture picture = map_picture(map, {});
    EXPECT_LE(picture.cells.cols, 4000);
    EXPECT_NEAR(picture.cell_m, 0.2, 1e-6);
    EXPECT_NEAR(picture.left_m, 0.5, 0.11);
}

}  // namespace
}  // namespace flownav::report
