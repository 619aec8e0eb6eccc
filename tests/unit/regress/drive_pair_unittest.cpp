#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <opencv2/core.hpp>

#include "app_runs.h"
#include "flownav/math/units.h"
#include "flownav/regress/column_file.h"
#include "flownav/regress/paired_charts.h"
#include "flownav/regress/paired_maps.h"

// Suppresses a leak: MRPT does not free the parser of an invalid YAML text.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
    return "leak:libfyaml";
}

namespace flownav::regress {
namespace {

namespace fs = std::filesystem;

constexpr std::uint8_t occupied = 0, unknown = 205, free_cell = 254;

class DrivePair : public ::testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    fs::path folder_ = testing::folder_of_test("drive_pair");
};

/// A run of `fields` fields in cycles of three, with `points` obstacle points at the end of each cycle.
Columns run_of(std::size_t fields, double points, double turn_radps = 0.1) {
    Columns run;
    for (std::size_t i = 0; i < fields; ++i) {
        run["timestamp"].push_back(1000.0 + 0.04 * static_cast<double>(i));
        run["image_of_cycle"].push_back(i == 0 ? 0.0 : static_cast<double>((i - 1) % 3 + 1));
        run["omega_radps"].push_back(i == 0 ? std::nan("") : turn_radps);
        run["obstacles"].push_back(i > 0 && i % 3 == 0 ? points : 0.0);
    }
    return run;
}

const report::ReportChart& chart(const std::vector<report::ReportChart>& charts, const std::string& id) {
    for (const report::ReportChart& one : charts)
        if (one.id == id) return one;
    throw std::out_of_range(id);
}

MapFile map_of(int columns, int rows, double cell_m) {
    return {cv::Mat(rows, columns, CV_8UC1, cv::Scalar(unknown)), 0.0, 0.0, cell_m};
}

TEST_F(DrivePair, CellsThatAreEmptyOrWordsAreNoNumbers) {
    write("x.csv", "t,status,v\n1.5,ok,\n2,lost,-3e-1\r\n3\n");
    const Columns columns = read_csv(folder_ / "x.csv");
    EXPECT_EQ(columns.at("t"), (std::vector<double>{1.5, 2.0, 3.0}));
    EXPECT_TRUE(std::isnan(columns.at("status")[0]));
    EXPECT_TRUE(std::isnan(columns.at("v")[0]));
    EXPECT_EQ(columns.at("v")[1], -0.3);
    EXPECT_TRUE(std::isnan(columns.at("v")[2]));
    EXPECT_TRUE(read_csv(folder_ / "none.csv").empty());
    EXPECT_TRUE(read_tum(folder_ / "none.tum").empty());
}

TEST_F(DrivePair, CountsAreComparedAtTheEndsOfCycles) {
    const auto charts = paired_charts(run_of(7, 20.0), run_of(7, 15.0));
    const report::ReportChart& obstacles = chart(charts, "obstacles");
    ASSERT_EQ(obstacles.t_s.size(), 7U);
    for (const std::size_t end : {3U, 6U}) {
        EXPECT_EQ(obstacles.series[0].values[end], 20.0);
        EXPECT_EQ(obstacles.series[1].values[end], 15.0);
        EXPECT_EQ(obstacles.series[2].values[end], -5.0);
    }
    EXPECT_EQ(obstacles.series[0].values[2], report::ReportSeries::none);
}

TEST_F(DrivePair, WhatWasNotMeasuredInterruptsTheCurve) {
    const report::ReportChart turn = chart(paired_charts(run_of(4, 1.0), run_of(4, 1.0)), "omega_radps");
    EXPECT_EQ(turn.series[0].values[0], report::ReportSeries::gap);
    EXPECT_NEAR(turn.series[0].values[1], deg(0.1), 1e-9);
    EXPECT_EQ(turn.series[2].values[0], report::ReportSeries::none);
}

TEST_F(DrivePair, RunsWithOtherTimesAreMerged) {
    Columns other = run_of(4, 1.0);
    for (double& t : other["timestamp"]) t += 0.02;
    const report::ReportChart turn = chart(paired_charts(run_of(4, 1.0), other), "omega_radps");
    ASSERT_EQ(turn.t_s.size(), 8U);
    EXPECT_EQ(turn.series[1].values[2], report::ReportSeries::none);
    EXPECT_NE(turn.series[0].values[2], report::ReportSeries::none);
    for (const double difference : turn.series[2].values) EXPECT_EQ(difference, report::ReportSeries::none);
}

TEST_F(DrivePair, WhatACycleFoundHoldsUntilTheNextEnds) {
    Columns other = run_of(7, 15.0);
    for (double& t : other["timestamp"]) t += 0.04;  // its cycles end one field later
    const report::ReportChart obstacles = chart(paired_charts(run_of(7, 20.0), other), "obstacles");
    ASSERT_EQ(obstacles.t_s.size(), 8U);
    EXPECT_EQ(obstacles.series[2].values[3], report::ReportSeries::none) << "one is not known yet";
    EXPECT_EQ(obstacles.series[2].values[4], -5.0);
    EXPECT_EQ(obstacles.series[2].values[5], report::ReportSeries::none) << "nothing new";
    EXPECT_EQ(obstacles.series[2].values[6], -5.0);
}

TEST_F(DrivePair, ContactsAreComparedAtTheFieldsThatBroughtAScan) {
    Columns before = run_of(7, 20.0), after = run_of(7, 20.0);
    before["strips_obstacle"] = after["strips_obstacle"] = std::vector<double>(7, std::nan(""));
    before["strips_obstacle"][4] = 3.0;  // one field after the end of the cycle
    after["strips_obstacle"][4] = 5.0;
    const auto charts = paired_charts(before, after);
    const report::ReportChart& contacts = chart(charts, "strips_obstacle");
    EXPECT_EQ(contacts.series[0].values[4], 3.0);
    EXPECT_EQ(contacts.series[2].values[4], 2.0);
    EXPECT_EQ(contacts.series[0].values[3], report::ReportSeries::none) << "no interruption";
}

TEST_F(DrivePair, RunsOfAVersionWithoutTheColumnHaveNoCurveOfContacts) {
    Columns after = run_of(7, 20.0);
    after["strips_obstacle"] = std::vector<double>(7, 1.0);
    EXPECT_THROW(chart(paired_charts(run_of(7, 20.0), after), "strips_obstacle"), std::out_of_range);
}

TEST_F(DrivePair, WithoutFilesThereAreNoCurves) {
    EXPECT_TRUE(paired_charts({}, run_of(4, 1.0)).empty());
}

TEST_F(DrivePair, MapsAreReadWithTheirPlace) {
    write("map.yaml", "image: map.pgm\nresolution: 0.1\norigin: [-2, -3.5, 0.0]\nnegate: 0\n");
    write("map.pgm", std::string("P5\n2 1\n255\n") + '\0' + static_cast<char>(254));
    const auto map = read_map(folder_);
    ASSERT_TRUE(map);
    EXPECT_EQ(map->left_m, -2.0);
    EXPECT_EQ(map->bottom_m, -3.5);
    EXPECT_EQ(map->cell_m, 0.1);
    EXPECT_EQ(map->cells.at<std::uint8_t>(0, 0), occupied);
    EXPECT_EQ(map->cells.at<std::uint8_t>(0, 1), free_cell);
}

TEST_F(DrivePair, DamagedMapsAreNone) {
    EXPECT_FALSE(read_map(folder_));
    write("map.yaml", "resolution: 0.1\norigin: [0, 0, 0]\n");
    EXPECT_FALSE(read_map(folder_)) << "no picture";
    write("map.pgm", "P5\n1 1\n255\n0");
    EXPECT_TRUE(read_map(folder_));
    for (const char* bad : {"origin: [0, 0, 0]\n", "resolution: x\norigin: [0, 0]\n", "{ [", ""}) {
        write("map.yaml", bad);
        EXPECT_FALSE(read_map(folder_)) << bad;
    }
}

TEST_F(DrivePair, OccupiedCellsAreComparedAtTheirPlaces) {
    MapFile before = map_of(10, 8, 0.5), after = map_of(20, 20, 0.5);
    after.left_m = -2.0;  // 4 cells further left and 2 lower
    after.bottom_m = -1.0;
    before.cells.at<std::uint8_t>(7 - 3, 5) = occupied;  // at x 2.5, y 1.5
    after.cells.at<std::uint8_t>(19 - 5, 9) = occupied;  // the cell of `after` at the same position
    before.cells.at<std::uint8_t>(7, 0) = occupied;
    after.cells.at<std::uint8_t>(19 - 6, 9) = occupied;
    after.cells.at<std::uint8_t>(19 - 6, 10) = occupied;
    const auto maps = paired(before, after);
    ASSERT_TRUE(maps);
    EXPECT_EQ(maps->both, 1);
    EXPECT_EQ(maps->only_before, 1);
    EXPECT_EQ(maps->only_after, 2);
    EXPECT_LT(maps->before.cols, 20) << "only what is known";
    const DifferenceColours colours = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {5, 5, 5}};
    cv::Mat first;
    cv::extractChannel(difference_picture(*maps, colours), first, 0);
    EXPECT_EQ(cv::countNonZero(first == 1), 1);
    EXPECT_EQ(cv::countNonZero(first == 2), 2);
    EXPECT_EQ(cv::countNonZero(first == 3), 1);
}

TEST_F(DrivePair, CellsOfTwoSizesAreComparedWithTheSmaller) {
    MapFile before = map_of(4, 4, 1.0), after = map_of(8, 8, 0.5);
    before.cells.at<std::uint8_t>(1, 1) = occupied;
    after.cells(cv::Rect(2, 2, 2, 2)) = occupied;
    const auto maps = paired(before, after);
    ASSERT_TRUE(maps);
    EXPECT_EQ(maps->cell_m, 0.5);
    EXPECT_EQ(maps->both, 4);
    EXPECT_EQ(maps->only_before + maps->only_after, 0);
}

TEST_F(DrivePair, ALargeMapBecomesCoarserAndLosesNoObstacle) {
    MapFile map = map_of(5000, 40, 0.1);
    map.cells = free_cell;
    map.cells.at<std::uint8_t>(20, 2500) = occupied;
    const auto maps = paired(map, map);
    ASSERT_TRUE(maps);
    EXPECT_LT(maps->before.cols, 1300);
    EXPECT_EQ(maps->both, 1);
}

TEST_F(DrivePair, MapsWithoutAnythingAreNone) {
    EXPECT_FALSE(paired(map_of(4, 4, 1.0), map_of(4, 4, 1.0)));
}

}  // namespace
}  // namespace flownav::regress
