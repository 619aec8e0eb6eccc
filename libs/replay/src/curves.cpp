#include "flownav/replay/curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace flownav {

namespace {

const char* const flow_colour = "#0072b2";
const char* const odometry_colour = "#d55e00";
const char* const truth_colour = "#000000";
constexpr double visible_gaps = 500.0;  ///< gaps shorter than a drive's duration over this are drawn through
constexpr double gap_fields = 3.0;      ///< and so are gaps of this many fields
constexpr double gap_cycle_fields = 15.0;

using Value = std::function<std::optional<double>(const FieldRow&)>;

double to_deg(double angle_rad) {
    return angle_rad * 180.0 / M_PI;
}

/// A curve over time; a row without value leaves a gap.
ChartSeries over_time(const std::string& name, const char* colour, const Drive& drive, const Value& value,
                      double drawn_through_fields = gap_fields) {
    ChartSeries series{name, colour, {}, false};
    if (drive.rows.empty()) return series;
    const double start_s = drive.rows.front().timestamp_s;
    const double duration_s = drive.rows.back().timestamp_s - start_s;
    const double fields = static_cast<double>(drive.rows.size());
    const double gap_s = std::max(drawn_through_fields * duration_s / fields, duration_s / visible_gaps);
    double last_s = -HUGE_VAL;
    for (const FieldRow& row : drive.rows) {
        const auto y = value(row);
        if (!y) continue;
        if (row.timestamp_s - last_s > gap_s) series.pieces.emplace_back();
        series.pieces.back().emplace_back(row.timestamp_s - start_s, *y);
        last_s = row.timestamp_s;
    }
    return series;
}

/// Another track's poses in the frame of its pose at the first field, on the ground.
struct GroundTrack {
    std::vector<double> timestamps_s;
    std::vector<Pose2> poses;
    std::vector<double> unwrapped_rad;
};

void append_heading(GroundTrack& track) {
    const double now_rad = track.poses.back().yaw_rad;
    const double before_rad = track.unwrapped_rad.empty() ? 0.0 : track.unwrapped_rad.back();
    track.unwrapped_rad.push_back(before_rad + wrap_angle(now_rad - before_rad));
}

GroundTrack ground_track(const Drive& drive, const PoseTrack& track) {
    GroundTrack result;
    if (drive.rows.empty()) return result;
    for (const TimedPose& sample : track.aligned(drive.rows.front().timestamp_s)) {
        if (sample.timestamp_s > drive.rows.back().timestamp_s) break;
        result.timestamps_s.push_back(sample.timestamp_s);
        result.poses.push_back({sample.pose.x, sample.pose.y, sample.pose.yaw});
        append_heading(result);
    }
    return result;
}

GroundTrack flow_track(const Drive& drive) {
    GroundTrack result;
    for (const FieldRow& row : drive.rows) {
        result.timestamps_s.push_back(row.timestamp_s);
        result.poses.push_back(row.T_start_robot);
        append_heading(result);
    }
    return result;
}

ChartSeries plan(const std::string& name, const char* colour, const GroundTrack& track) {
    ChartSeries series{name, colour, {}, false};
    if (!track.poses.empty()) series.pieces.emplace_back();
    for (const Pose2& pose : track.poses) series.pieces.back().emplace_back(pose.x_m, pose.y_m);
    return series;
}

ChartSeries heading(const std::string& name, const char* colour, const GroundTrack& track, double start_s) {
    ChartSeries series{name, colour, {}, false};
    if (!track.poses.empty()) series.pieces.emplace_back();
    for (std::size_t i = 0; i < track.poses.size(); ++i) {
        series.pieces.back().emplace_back(track.timestamps_s[i] - start_s, to_deg(track.unwrapped_rad[i]));
    }
    return series;
}

/// Rates of another track between one field and the next.
ChartSeries rate(const std::string& name, const char* colour, const Drive& drive, const PoseTrack& track,
                 const std::function<double(const Pose2&)>& component) {
    std::optional<Pose2> before;
    double before_s = 0.0;
    return over_time(name, colour, drive, [=, &track](const FieldRow& row) mutable -> std::optional<double> {
        const auto now = track.ground_at(row.timestamp_s);
        std::optional<double> result;
        if (now && before) {
            result = component(compose(inverse(*before), *now)) / (row.timestamp_s - before_s);
        }
        before = now;
        before_s = row.timestamp_s;
        return result;
    });
}

/// Adds the tracks the drive has, truth below everything, flow on top.
template <typename MakeSeries>
void add_tracks(Chart& chart, const Drive& drive, const MakeSeries& make, ChartSeries flow) {
    if (!drive.ground_truth.empty())
        chart.series.push_back(make("ground truth", truth_colour, drive.ground_truth));
    if (!drive.odometry.empty()) chart.series.push_back(make("odometry", odometry_colour, drive.odometry));
    for (ChartSeries& series : chart.series) series.dashed = series.name == "odometry";
    chart.series.push_back(std::move(flow));
}

Chart trajectory_chart(const Drive& drive) {
    Chart chart{"Trajectory, seen from above",
                "x, ahead of the start (m)",
                "y, left of the start (m)",
                {},
                true,
                false};
    const auto make = [&](const char* name, const char* colour, const PoseTrack& track) {
        return plan(name, colour, ground_track(drive, track));
    };
    add_tracks(chart, drive, make, plan("flow", flow_colour, flow_track(drive)));
    return chart;
}

Chart heading_chart(const Drive& drive) {
    const double start_s = drive.rows.empty() ? 0.0 : drive.rows.front().timestamp_s;
    Chart chart{"Heading, > 0: turned left", "time (s)", "heading (deg)", {}, false, false};
    const auto make = [&](const char* name, const char* colour, const PoseTrack& track) {
        return heading(name, colour, ground_track(drive, track), start_s);
    };
    add_tracks(chart, drive, make, heading("flow", flow_colour, flow_track(drive), start_s));
    return chart;
}

Chart rate_chart(const Drive& drive, const Chart& labels,
                 const std::function<double(const Pose2&)>& component, const Value& flow) {
    Chart chart = labels;
    const auto make = [&](const char* name, const char* colour, const PoseTrack& track) {
        return rate(name, colour, drive, track, component);
    };
    add_tracks(chart, drive, make, over_time("flow", flow_colour, drive, flow, gap_cycle_fields));
    return chart;
}

Chart omega_chart(const Drive& drive) {
    const auto flow = [](const FieldRow& row) -> std::optional<double> {
        if (row.status != FieldStatus::Ok) return std::nullopt;
        return to_deg(row.omega_radps);
    };
    const auto turn = [](const Pose2& step) { return to_deg(wrap_angle(step.yaw_rad)); };
    return rate_chart(drive,
                      {"Turn rate, > 0: to the left", "time (s)", "turn rate (deg/s)", {}, false, false},
                      turn, flow);
}

Chart speed_chart(const Drive& drive) {
    const auto flow = [](const FieldRow& row) -> std::optional<double> {
        if (!row.v_measured) return std::nullopt;
        return row.v_mps;
    };
    const auto forward = [](const Pose2& step) {
        return std::copysign(std::hypot(step.x_m, step.y_m), step.x_m);
    };
    return rate_chart(drive,
                      {"Forward speed, where it was measured", "time (s)", "speed (m/s)", {}, false, true},
                      forward, flow);
}

Chart counts_chart(const Drive& drive) {
    Chart chart{"Blocks and obstacle points per field", "time (s)", "count", {}, false, true};
    const auto count = [&](const char* name, const char* colour, int FieldRow::*member) {
        return over_time(name, colour, drive,
                         [member](const FieldRow& row) { return std::optional<double>(row.*member); });
    };
    chart.series.push_back(count("placed", "#999999", &FieldRow::placed));
    chart.series.push_back(count("confident", "#56b4e9", &FieldRow::confident));
    chart.series.push_back(count("supporting the turn rate", "#009e73", &FieldRow::inliers));
    chart.series.push_back(over_time(
        "obstacle points of a cycle", "#d55e00", drive,
        [](const FieldRow& row) -> std::optional<double> {
            if (!row.end_of_cycle) return std::nullopt;
            return row.obstacles;
        },
        gap_cycle_fields));
    return chart;
}

}  // namespace

std::vector<Chart> charts_of(const Drive& drive) {
    return {trajectory_chart(drive), heading_chart(drive), omega_chart(drive), speed_chart(drive),
            counts_chart(drive)};
}

}  // namespace flownav
