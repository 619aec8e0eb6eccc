#include "flownav/evaluation/summary.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "step_samples.h"

namespace flownav::evaluation {
namespace {

using testing::sample_drive;

TEST(Summary, HoldsCountsErrorsConfigurationAndOneTimingObject) {
    Drive drive = sample_drive(100);
    drive.read.rejected["time_repeated"] = 2;
    drive.written.cycles = 24;
    drive.written.map_cells = {7, 90};
    Timing timing;
    timing.total_s = 2.0;
    timing.fields.resize(100);
    const auto json = nlohmann::json::parse(summary_json(drive, config::Config{}, timing));
    EXPECT_EQ(json["input"]["file"], "sample.rawlog");
    EXPECT_EQ(json["input"]["end"], "clean");
    EXPECT_EQ(json["rejected"]["time_repeated"], 2);
    EXPECT_EQ(json["written"]["cycles"], 24);
    EXPECT_EQ(json["written"]["map_occupied_cells"], 7);
    EXPECT_EQ(json["written"]["map_free_cells"], 90);
    EXPECT_EQ(json["status"]["ok"], 99);
    EXPECT_EQ(json["status"]["waiting"], 1);
    EXPECT_EQ(json["errors"]["ground_truth"]["fields_compared"], 100);
    EXPECT_NEAR(json["errors"]["ground_truth"]["omega_rms_degps"].get<double>(), 0.0, 1e-6);
    EXPECT_EQ(json["config"]["flow"]["blocks"], "350");
    EXPECT_EQ(json["timing"]["fields_per_s"], 50.0);
}

TEST(Summary, HoldsTheFiguresOfTheContactScans) {
    const auto json = nlohmann::json::parse(summary_json(sample_drive(21), config::Config{}, {}));
    const auto& contacts = json["contacts"];
    EXPECT_EQ(contacts["scans"], 5);
    EXPECT_EQ(contacts["rows"], 30);
    EXPECT_EQ(contacts["scanned_percent"], 100.0);
    EXPECT_EQ(contacts["by_gate"]["open"], 5);
    EXPECT_EQ(contacts["by_gate"]["no_travel"], 0);
    EXPECT_EQ(contacts["contacts"], 3.0);
    EXPECT_EQ(contacts["by_cause"]["wall"], 5);
    EXPECT_EQ(contacts["floor_fit"], 0.81);
    EXPECT_EQ(contacts["vignetting"], 0.2);
}

TEST(Summary, WhatCouldNotBeComputedIsNull) {
    Drive drive = sample_drive(3);
    drive.odometry_errors.reset();
    const auto json = nlohmann::json::parse(summary_json(drive, config::Config{}, {}));
    EXPECT_TRUE(json["errors"]["odometry"].is_null());
    EXPECT_TRUE(json["errors"]["ground_truth"]["omega_rms_degps"].is_null());
    EXPECT_TRUE(json["contacts"]["contacts"].is_null()) << "no cycle has ended";
    EXPECT_TRUE(json["contacts"]["vignetting"].is_null());
}

TEST(Summary, OnlyTheTimingDependsOnTheRun) {
    const Timing slow = {{1.0, 2.0, 3.0, 4.0, 5.0}, {{1000.0, {1.0, 2.0}}}, 16.0, 1, "portable"};
    const Timing fast = {{0.1, 0.2, 0.3, 0.4, 0.5}, {}, 1.6, 8, "other"};
    auto a = nlohmann::ordered_json::parse(summary_json(sample_drive(20), config::Config{}, slow));
    auto b = nlohmann::ordered_json::parse(summary_json(sample_drive(20), config::Config{}, fast));
    EXPECT_NE(a.dump(), b.dump());
    a.erase("timing");
    b.erase("timing");
    EXPECT_EQ(a.dump(), b.dump());
}

TEST(Summary, AFileNameThatIsNoUtf8IsNoReasonToFail) {
    Drive drive = sample_drive(3);
    drive.input_name = "caf\xe9.rawlog";
    EXPECT_NO_THROW(nlohmann::json::parse(summary_json(drive, config::Config{}, {})));
}

}  // namespace
}  // namespace flownav::evaluation
