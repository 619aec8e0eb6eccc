#include "flownav/evaluation/findings.h"

#include <gtest/gtest.h>
#include <mrpt/poses/CPose3D.h>

#include <cmath>
#include <functional>

#include "flownav/math/units.h"

/// Sentences about odd recordings.
namespace flownav::evaluation {
namespace {

const Finding* find(const std::vector<Finding>& findings, const std::string& reason) {
    for (const Finding& finding : findings)
        if (finding.reason == reason) return &finding;
    return nullptr;
}

void expect_told(const std::vector<Finding>& findings, const std::string& reason,
                 std::initializer_list<const char*> parts, bool loses_data = false) {
    const Finding* finding = find(findings, reason);
    ASSERT_NE(finding, nullptr) << reason;
    EXPECT_EQ(finding->loses_data, loses_data) << finding->sentence;
    for (const char* part : parts)
        EXPECT_NE(finding->sentence.find(part), std::string::npos) << part << " in: " << finding->sentence;
    EXPECT_NE(finding->sentence.find("share/doc/odd_recordings.md"), std::string::npos);
}

io::InputCounts counts_of(std::uint64_t images) {
    io::InputCounts read;
    read.images = read.fields = images;
    read.odometry = images;
    read.observations["CObservationImage CAMERA1"] = images;
    read.observations["CObservationOdometry ODOMETRY"] = images;
    return read;
}

/// Speed and turn rate of a drive at a time after its start.
struct Motion {
    double v_mps = 0.0, omega_radps = 0.0;
};
using Plan = std::function<Motion(double)>;

Motion sometimes_turning(double time_s) {
    return time_s > 2.0 && time_s < 4.0 ? Motion{0.1, 0.4} : Motion{0.4, 0.0};
}

constexpr double start_s = 1000.0;
constexpr double step_s = 0.04;
constexpr int steps = 200;

std::vector<FieldRow> rows_of(const Plan& plan) {
    std::vector<FieldRow> rows;
    Pose2 pose;
    for (int i = 0; i < steps; ++i) {
        const Motion motion = plan(i * step_s);
        FieldRow row;
        row.timestamp_s = start_s + i * step_s;
        row.status = i == 0 ? FieldStatus::Waiting : FieldStatus::Ok;
        if (i > 0) pose = compose(pose, along_arc(motion.omega_radps * step_s, motion.v_mps * step_s));
        row.omega_radps = motion.omega_radps;
        row.v_mps = motion.v_mps;
        row.omega_source = row.forward_source = MotionSource::Flow;
        row.T_start_robot = pose;
        rows.push_back(row);
    }
    return rows;
}

PoseTrack track_of(const Plan& plan, double offset_s = 0.0) {
    PoseTrack track;
    Pose2 pose;
    for (int i = 0; i < steps; ++i) {
        const Motion motion = plan(i * step_s);
        if (i > 0) pose = compose(pose, along_arc(motion.omega_radps * step_s, motion.v_mps * step_s));
        track.add(start_s + i * step_s + offset_s, {pose.x_m, pose.y_m, 0, pose.yaw_rad, 0, 0});
    }
    track.finish();
    return track;
}

Plan scaled(double way, double turn) {
    return [way, turn](double time_s) {
        const Motion motion = sometimes_turning(time_s);
        return Motion{way * motion.v_mps, turn * motion.omega_radps};
    };
}

TEST(InputFindings, AWholeRecordingHasNone) {
    EXPECT_TRUE(input_findings(counts_of(100), {}).empty());
}

TEST(InputFindings, AReasonAboveTwoPercentIsTold) {
    io::InputCounts read = counts_of(100);
    read.rejected["image_unreadable"] = 2;
    EXPECT_TRUE(input_findings(read, {}).empty());
    read.rejected["image_unreadable"] = 3;
    expect_told(input_findings(read, {}), "image_unreadable", {"3 of 100 images (3.0 %)"}, true);
}

TEST(InputFindings, EveryReasonOfEveryKindIsTold) {
    for (const char* prefix : {"", "odometry_", "ground_truth_", "gyro_"}) {
        for (const char* reason : {"time_invalid", "time_out_of_range", "time_repeated", "time_backwards"}) {
            io::InputCounts read = counts_of(100);
            read.rejected[std::string(prefix) + reason] = 50;
            expect_told(input_findings(read, {}), std::string(prefix) + reason, {"50 of "}, true);
        }
    }
}

TEST(InputFindings, OneStampFarAheadIsToldInAnyRecording) {
    io::InputCounts read = counts_of(1000);
    read.rejected["time_ahead"] = 1;
    expect_told(input_findings(read, {}), "time_ahead", {"1 of 1000 images"});
}

TEST(InputFindings, StampsOfWholeSecondsAreNamed) {
    io::InputCounts read = counts_of(100);
    read.rejected["time_repeated"] = 96;
    read.details["images_at_whole_seconds"] = 100;
    expect_told(input_findings(read, {}), "time_repeated", {"96 of 100", "whole seconds", "--rate"}, true);
}

TEST(InputFindings, AClockThatWasSetBackIsTold) {
    io::InputCounts read = counts_of(100);
    read.warnings["odometry_clock_set_back"] = 1;
    read.details["odometry_clock_set_back_s"] = 3600;
    expect_told(input_findings(read, {}), "odometry_clock_set_back", {"odometry", "1 time", "3600.00 s"});
}

TEST(InputFindings, ConvertedCalibrationsAreTold) {
    for (const char* reason : {"calibration_scaled", "pose_x_forward", "principal_point_off_centre"}) {
        io::InputCounts read = counts_of(100);
        read.warnings[reason] = 100;
        expect_told(input_findings(read, {}), reason, {"100 of 100 images", "camera."});
    }
}

TEST(InputFindings, OdometryOfAnotherLabelIsNamedWithTheKey) {
    io::InputCounts read = counts_of(100);
    read.observations.erase("CObservationOdometry ODOMETRY");
    read.observations["CObservationOdometry wheel odom"] = 77;
    expect_told(input_findings(read, {}), "odometry_label",
                {"77 poses", "'wheel odom'", "input.odometry_label = wheel odom"});
    read.observations["CObservationOdometry ODOMETRY"] = 5;
    EXPECT_TRUE(input_findings(read, {}).empty());
}

TEST(InputFindings, GroundTruthOfAnotherLabelIsNamedWithTheKey) {
    io::InputCounts read = counts_of(100);
    read.observations["CObservationRobotPose mocap"] = 30;
    expect_told(input_findings(read, {}), "truth_label", {"'mocap' (30)", "input.truth_label = mocap"});
}

TEST(InputFindings, ResultsOfFlownavAreNoOdometry) {
    io::InputCounts read = counts_of(100);
    read.observations.erase("CObservationOdometry ODOMETRY");
    read.observations["CObservationOdometry FLOW_ODOMETRY"] = 100;
    read.observations["CObservationRobotPose FLOW_POSE"] = 100;
    EXPECT_TRUE(input_findings(read, {}).empty());
}

TEST(FieldFindings, AGoodDriveHasNone) {
    EXPECT_TRUE(field_findings(rows_of(sometimes_turning), {}, {}).empty());
}

TEST(FieldFindings, ImagesFartherApartThanTheGapAreNamedWithTheKey) {
    auto rows = rows_of(sometimes_turning);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].timestamp_s = start_s + static_cast<double>(i);
        rows[i].status = FieldStatus::Waiting;
    }
    expect_told(field_findings(rows, {}, {}), "images_too_rare", {"1.00 s", "motion.gap_max_s = 1.5"}, true);
}

TEST(FieldFindings, ImagesMicrosecondsApartAreTold) {
    auto rows = rows_of(sometimes_turning);
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].timestamp_s = start_s + 4e-5 * static_cast<double>(i);
    expect_told(field_findings(rows, {}, {}), "images_too_frequent", {"40.0 microseconds", "unit"}, true);
}

TEST(FieldFindings, BadFieldsAreToldByReason) {
    FieldFaultCounts faults{};
    faults[static_cast<std::size_t>(FieldFault::NoPicture)] = 20;
    expect_told(field_findings(rows_of(sometimes_turning), faults, {}), "bad_fields",
                {"20 of 200 fields", "no_picture (20)"}, true);
}

TEST(FieldFindings, AViewThatGoesOnPitchingIsTold) {
    auto rows = rows_of(sometimes_turning);
    for (FieldRow& row : rows) row.pitch_rate_radps = -0.02;
    expect_told(field_findings(rows, {}, {}), "view_pitches", {"-9 deg", "camera.rotate = 180"});
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].pitch_rate_radps = i % 2 == 0 ? -0.5 : 0.49;
    EXPECT_TRUE(field_findings(rows, {}, {}).empty());
}

TEST(FieldFindings, ADriveWithoutMotionInMostFieldsIsTold) {
    auto rows = rows_of(sometimes_turning);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (i % 3 != 0) rows[i].status = i % 2 == 0 ? FieldStatus::Lost : FieldStatus::NoTexture;
    expect_told(field_findings(rows, {}, {}), "few_fields_ok", {"66 of 200 fields"});
}

TEST(TrackFindings, OdometryThatAgreesHasNone) {
    const auto rows = rows_of(sometimes_turning);
    EXPECT_TRUE(track_findings(rows, track_of(scaled(1.006, 1.01)), "odometry").empty());
    EXPECT_TRUE(track_findings(rows, track_of(scaled(0.98, 0.97)), "odometry").empty());
    EXPECT_TRUE(track_findings(rows, {}, "odometry").empty());
}

TEST(TrackFindings, AStandingRobotHasNone) {
    const auto still = [](double) { return Motion{}; };
    EXPECT_TRUE(track_findings(rows_of(still), track_of(still), "odometry").empty());
}

TEST(TrackFindings, AnotherLengthOfTheWayIsTold) {
    for (const double way : {0.5, 0.93, 1.07, 2.0})
        expect_told(track_findings(rows_of(scaled(way, 1.0)), track_of(sometimes_turning), "odometry"),
                    "odometry_way", {"camera.height_m", "by the odometry"});
}

TEST(TrackFindings, AMissingWayIsTold) {
    const auto findings =
        track_findings(rows_of([](double) { return Motion{}; }), track_of(sometimes_turning), "odometry");
    expect_told(findings, "odometry_way", {"0.00 m by the flow", "camera.mask"});
}

TEST(TrackFindings, MirroredTurnsAreTold) {
    expect_told(track_findings(rows_of(scaled(1.0, -1.0)), track_of(sometimes_turning), "odometry"),
                "odometry_turn_reversed", {"camera.mirror = true", "camera.rotate = 180"});
}

TEST(TrackFindings, AnotherSizeOfTurnsIsTold) {
    expect_told(track_findings(rows_of(scaled(1.0, 1.3)), track_of(sometimes_turning), "odometry"),
                "odometry_turn", {"1.30 times", "camera.fx_px"});
}

TEST(TrackFindings, AHeadingThatDriftsIsTold) {
    const auto drifting = [](double time_s) {
        const Motion motion = sometimes_turning(time_s);
        return Motion{motion.v_mps, motion.omega_radps + 0.01};
    };
    expect_told(track_findings(rows_of(drifting), track_of(sometimes_turning), "odometry"),
                "odometry_heading", {"4.6 deg to the left", "camera.yaw_deg"});
}

TEST(TrackFindings, AReversedWayIsTold) {
    expect_told(track_findings(rows_of(scaled(-1.0, 1.0)), track_of(sometimes_turning), "ground truth"),
                "ground_truth_way_reversed", {"backwards", "camera.rotate = 180"});
}

TEST(TrackFindings, OdometryOfAnotherClockIsToldWithItsOffset) {
    const auto findings =
        track_findings(rows_of(sometimes_turning), track_of(sometimes_turning, 7200.5), "odometry");
    expect_told(
        findings, "odometry_times",
        {"0 of 200 images", "7200.50 s later", "by the motion", "input.odometry_offset_s = -7200.50"});
    EXPECT_EQ(findings.size(), 1U);
}

TEST(TrackFindings, OdometryThatLagsIsToldWithItsOffset) {
    expect_told(track_findings(rows_of(sometimes_turning), track_of(sometimes_turning, 0.6), "odometry"),
                "odometry_offset", {"0.60 s later", "input.odometry_offset_s = -0.60"});
}

TEST(TrackFindings, AResetOfTheOdometryIsToldAndNothingElse) {
    const PoseTrack good = track_of(sometimes_turning);
    PoseTrack reset;
    const mrpt::poses::CPose3D origin(good.samples()[120].pose);
    for (std::size_t i = 0; i < good.samples().size(); ++i) {
        const auto& sample = good.samples()[i];
        const auto pose = mrpt::poses::CPose3D(sample.pose);
        reset.add(sample.timestamp_s, i < 120 ? sample.pose : (pose - origin).asTPose());
    }
    reset.finish();
    const auto findings = track_findings(rows_of(sometimes_turning), reset, "odometry");
    expect_told(findings, "odometry_jumps", {"jumps 1 time", "4.80 s", "reset"});
    EXPECT_EQ(findings.size(), 1U);
}

TEST(TrackFindings, ClocksOfDifferentSpeedAreTold) {
    PoseTrack slow;
    const PoseTrack good = track_of(sometimes_turning);
    for (const auto& sample : good.samples())
        slow.add(start_s + 1.5 * (sample.timestamp_s - start_s), sample.pose);
    slow.finish();
    expect_told(track_findings(rows_of(sometimes_turning), slow, "odometry"), "odometry_span",
                {"images last 7.96 s", "odometry 11.94 s"});
}

TEST(TrackFindings, SidewaysMotionIsTold) {
    PoseTrack crab;
    for (int i = 0; i < steps; ++i) crab.add(start_s + i * step_s, {0.01 * i, 0.01 * i, 0, 0, 0, 0});
    crab.finish();
    expect_told(track_findings(rows_of(scaled(1.0, 0.0)), crab, "odometry"), "odometry_sideways",
                {"sideways", "along their heading"});
}

}  // namespace
}  // namespace flownav::evaluation
