#include "flownav/replay/curves.h"

#include <cmath>
#include <functional>
#include <optional>

#include "track_series.h"

namespace flownav {

namespace {

constexpr double cycle_fields = 15.0;  ///< gaps between values that come once a cycle

const ChartSeries flow_look = {"flow", "#0072b2", {}, false, 1.8};
const ChartSeries odometry_look = {"odometry", "#d55e00", {}, true, 1.8};
const ChartSeries truth_look = {"ground truth", "#b5b5b5", {}, false, 5.0};

double to_deg(double angle_rad) {
    return angle_rad * 180.0 / M_PI;
}

double start_of(const Drive& drive) {
    return drive.rows.empty() ? 0.0 : drive.rows.front().timestamp_s;
}

Chart time_chart(const Drive& drive, const std::string& title, const std::string& y_label,
                 double least_y_span) {
    Chart chart;
    chart.title = title;
    chart.x_label = "time since the first field (s)";
    chart.y_label = y_label;
    chart.least_y_span = least_y_span;
    if (!drive.rows.empty()) chart.x_span = {0.0, drive.rows.back().timestamp_s - start_of(drive)};
    return chart;
}

/// Adds the tracks the drive has, truth below everything, flow on top.
template <typename MakeSeries>
void add_tracks(Chart& chart, const Drive& drive, const MakeSeries& other_track, ChartSeries flow) {
    if (!drive.ground_truth.empty()) chart.series.push_back(other_track(truth_look, drive.ground_truth));
    if (!drive.odometry.empty()) chart.series.push_back(other_track(odometry_look, drive.odometry));
    chart.series.push_back(std::move(flow));
}

Chart trajectory_chart(const Drive& drive) {
    Chart chart;
    chart.title = "Trajectory, seen from above";
    chart.x_label = "x, ahead of the start (m)";
    chart.y_label = "y, left of the start (m)";
    chart.equal_scales = true;
    const auto other = [&](const ChartSeries& look, const PoseTrack& track) {
        return plan(look, ground_track(drive, track));
    };
    add_tracks(chart, drive, other, plan(flow_look, flow_track(drive)));
    return chart;
}

Chart heading_chart(const Drive& drive) {
    Chart chart = time_chart(drive, "Heading, > 0: turned left", "heading (deg)", 2.0);
    const auto other = [&](const ChartSeries& look, const PoseTrack& track) {
        return heading(look, ground_track(drive, track), start_of(drive));
    };
    add_tracks(chart, drive, other, heading(flow_look, flow_track(drive), start_of(drive)));
    return chart;
}

Chart omega_chart(const Drive& drive) {
    Chart chart = time_chart(drive, "Turn rate, > 0: to the left", "turn rate (deg/s)", 2.0);
    const auto turn = [](const Pose2& motion) { return to_deg(wrap_angle(motion.yaw_rad)); };
    const auto other = [&](const ChartSeries& look, const PoseTrack& track) {
        return rate(look, drive, track, turn);
    };
    const auto measured = [](const FieldRow& row) -> std::optional<double> {
        if (row.status != FieldStatus::Ok) return std::nullopt;
        return to_deg(row.omega_radps);
    };
    add_tracks(chart, drive, other, over_time(flow_look, drive, measured));
    return chart;
}

Chart speed_chart(const Drive& drive) {
    Chart chart =
        time_chart(drive, "Forward speed, as measured at the end of each cycle", "speed (m/s)", 0.1);
    chart.y_from_zero = true;
    const auto forward = [](const Pose2& motion) {
        return std::copysign(std::hypot(motion.x_m, motion.y_m), motion.x_m);
    };
    const auto other = [&](const ChartSeries& look, const PoseTrack& track) {
        return rate(look, drive, track, forward);
    };
    const auto measured = [](const FieldRow& row) -> std::optional<double> {
        if (!row.v_measured) return std::nullopt;
        return row.v_mps;
    };
    add_tracks(chart, drive, other, over_time(flow_look, drive, measured, cycle_fields));
    return chart;
}

/// Distance between the ground truth and a pose known at each field, both from the first field with truth.
ChartSeries distance(const ChartSeries& look, const Drive& drive,
                     const std::function<std::optional<Pose2>(const FieldRow&)>& pose_at) {
    std::optional<Pose2> first_truth;
    std::optional<Pose2> first_pose;
    return over_time(look, drive, [&](const FieldRow& row) -> std::optional<double> {
        const auto truth = drive.ground_truth.ground_at(row.timestamp_s);
        const auto pose = pose_at(row);
        if (!truth || !pose) return std::nullopt;
        if (!first_truth) {
            first_truth = truth;
            first_pose = pose;
        }
        const Pose2 a = compose(inverse(*first_truth), *truth);
        const Pose2 b = compose(inverse(*first_pose), *pose);
        return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
    });
}

Chart distance_chart(const Drive& drive) {
    Chart chart = time_chart(drive, "Distance from the ground truth", "distance (m)", 0.002);
    chart.y_from_zero = true;
    if (!drive.odometry.empty()) {
        const auto at = [&](const FieldRow& row) { return drive.odometry.ground_at(row.timestamp_s); };
        chart.series.push_back(distance(odometry_look, drive, at));
    }
    const auto flow = [](const FieldRow& row) { return std::optional<Pose2>(row.T_start_robot); };
    chart.series.push_back(distance(flow_look, drive, flow));
    return chart;
}

Chart counts_chart(const Drive& drive) {
    Chart chart = time_chart(drive, "Blocks per field, and obstacle points per cycle", "count", 10.0);
    chart.y_from_zero = true;
    const auto count = [&](const char* name, const char* colour, int FieldRow::*member) {
        const auto value = [member](const FieldRow& row) { return std::optional<double>(row.*member); };
        return over_time({name, colour, {}, false, 1.8}, drive, value);
    };
    chart.series.push_back(count("placed", "#999999", &FieldRow::placed));
    chart.series.push_back(count("confident", "#56b4e9", &FieldRow::confident));
    chart.series.push_back(count("supporting the turn rate", "#009e73", &FieldRow::inliers));
    const auto points = [](const FieldRow& row) -> std::optional<double> {
        if (!row.end_of_cycle) return std::nullopt;
        return row.obstacles;
    };
    chart.series.push_back(
        over_time({"obstacle points", "#d55e00", {}, false, 1.8}, drive, points, cycle_fields));
    return chart;
}

}  // namespace

std::vector<Chart> charts_of(const Drive& drive) {
    std::vector<Chart> charts = {trajectory_chart(drive), heading_chart(drive)};
    if (!drive.ground_truth.empty()) charts.push_back(distance_chart(drive));
    charts.push_back(omega_chart(drive));
    charts.push_back(speed_chart(drive));
    charts.push_back(counts_chart(drive));
    return charts;
}

}  // namespace flownav
