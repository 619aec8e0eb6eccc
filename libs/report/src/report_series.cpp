#include "report_series.h"

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "contact_charts.h"
#include "flownav/math/units.h"
#include "flownav/report/label_style.h"

namespace flownav::report {

namespace {

using Value = std::function<std::optional<double>(const evaluation::FieldRow&)>;

const ReportSeries flow_look = {"flow", palette::blue, false, 2.0, false, {}};
const ReportSeries odometry_look = {"odometry", palette::vermilion, true, 1.8, false, {}};
const ReportSeries truth_look = {"ground truth", Colour{176, 176, 176}, false, 5.0, false, {}};

ReportSeries series_of(ReportSeries look, const evaluation::Drive& drive, const Value& value) {
    look.values.reserve(drive.rows.size());
    for (const evaluation::FieldRow& row : drive.rows)
        look.values.push_back(value(row).value_or(ReportSeries::gap));
    return look;
}

ReportChart chart_of(const evaluation::Drive& drive, const char* id, const char* title, const char* quantity,
                     const char* unit, const char* note) {
    ReportChart chart;
    chart.id = id;
    chart.title = title;
    chart.quantity = quantity;
    chart.unit = unit;
    chart.note = note;
    for (const evaluation::FieldRow& row : drive.rows)
        chart.t_s.push_back(row.timestamp_s - drive.rows.front().timestamp_s);
    return chart;
}

/// A rate of another track: `component` of its motion from the field before, per second.
Value rate_of(const evaluation::PoseTrack& track, double (*component)(const Pose2&)) {
    struct Before {
        std::optional<Pose2> pose;
        double timestamp_s = 0.0;
    };
    return [&track, component,
            before = Before{}](const evaluation::FieldRow& row) mutable -> std::optional<double> {
        const Before last = std::exchange(before, {track.ground_at(row.timestamp_s), row.timestamp_s});
        if (!last.pose || !before.pose) return std::nullopt;
        return component(compose(inverse(*last.pose), *before.pose)) / (row.timestamp_s - last.timestamp_s);
    };
}

/// Truth below everything, flow on top.
void add_rates(ReportChart& chart, const evaluation::Drive& drive, double (*component)(const Pose2&),
               ReportSeries flow) {
    if (!drive.ground_truth.empty())
        chart.series.push_back(series_of(truth_look, drive, rate_of(drive.ground_truth, component)));
    if (!drive.odometry.empty())
        chart.series.push_back(series_of(odometry_look, drive, rate_of(drive.odometry, component)));
    chart.series.push_back(std::move(flow));
}

ReportChart turn_chart(const evaluation::Drive& drive) {
    ReportChart chart = chart_of(drive, "turn", "Turn rate", "turn rate", "deg/s",
                                 "Positive: to the left. Measured with every field.");
    chart.least_span = 2.0;
    const auto measured = [](const evaluation::FieldRow& row) -> std::optional<double> {
        if (row.status != FieldStatus::Ok) return std::nullopt;
        return deg(row.omega_radps);
    };
    const auto turn = [](const Pose2& motion) { return deg(wrap_angle(motion.yaw_rad)); };
    add_rates(chart, drive, turn, series_of(flow_look, drive, measured));
    return chart;
}

ReportChart speed_chart(const evaluation::Drive& drive) {
    ReportChart chart = chart_of(drive, "speed", "Forward speed", "speed", "m/s",
                                 "By flow: the mean of each cycle that measured it, at the cycle's end.");
    chart.from_zero = true;
    chart.least_span = 0.1;
    ReportSeries flow = flow_look;
    flow.connected = true;
    for (const evaluation::FieldRow& row : drive.rows) {
        const double unmeasured = row.status == FieldStatus::Ok ? ReportSeries::none : ReportSeries::gap;
        flow.values.push_back(row.v_measured ? row.v_mps : unmeasured);
    }
    const auto forward = [](const Pose2& motion) {
        return std::copysign(std::hypot(motion.x_m, motion.y_m), motion.x_m);
    };
    add_rates(chart, drive, forward, std::move(flow));
    return chart;
}

ReportChart heading_chart(const evaluation::Drive& drive) {
    ReportChart chart = chart_of(drive, "heading", "Heading", "heading", "deg",
                                 "Since the first field. Positive: turned left.");
    chart.least_span = 2.0;
    for (ReportTrack& track : report_tracks(drive)) {
        double unwrapped_rad = 0.0;
        for (const Pose2& pose : track.poses) {
            const bool known = std::isfinite(pose.yaw_rad);
            if (known) unwrapped_rad += wrap_angle(pose.yaw_rad - unwrapped_rad);
            track.look.values.push_back(known ? deg(unwrapped_rad) : ReportSeries::gap);
        }
        chart.series.push_back(std::move(track.look));
    }
    return chart;
}

ReportChart distance_chart(const evaluation::Drive& drive) {
    ReportChart chart = chart_of(drive, "distance", "Distance from the ground truth", "distance", "m",
                                 "From the pose of the first field on.");
    chart.from_zero = true;
    chart.least_span = 0.01;
    chart.decimals = 5;
    const auto tracks = report_tracks(drive);
    for (std::size_t k = 1; k < tracks.size(); ++k) {
        ReportSeries series = tracks[k].look;
        for (std::size_t i = 0; i < drive.rows.size(); ++i) {
            const Pose2& truth = tracks[0].poses[i];
            const Pose2& pose = tracks[k].poses[i];
            const double apart_m = std::hypot(pose.x_m - truth.x_m, pose.y_m - truth.y_m);
            series.values.push_back(std::isfinite(apart_m) ? apart_m : ReportSeries::gap);
        }
        chart.series.push_back(std::move(series));
    }
    return chart;
}

/// A chart with a time for the end of each cycle and for each field without motion: within a cycle the counts
/// rise and fall, which hides what they tell.
ReportChart chart_of_cycles(const evaluation::Drive& drive, ChartRows& shown) {
    return chart_of_rows(drive, shown, [](const evaluation::FieldRow& row) {
        return row.end_of_cycle || row.status != FieldStatus::Ok;
    });
}

ReportChart labels_chart(const evaluation::Drive& drive) {
    ChartRows shown;
    ReportChart chart = chart_of_cycles(drive, shown);
    chart.id = "labels";
    chart.title = "Blocks by label";
    chart.quantity = "blocks";
    chart.note = "Stacked, at the end of each cycle: how the vectors of the cycle were classified.";
    chart.stacked = true;
    for (const LabelStyle& style : label_styles()) {
        ReportSeries series = {style.name, style.colour, false, 1.0, false, {}};
        const auto label = static_cast<std::size_t>(style.label);
        for (const evaluation::FieldRow* row : shown)
            series.values.push_back(row->end_of_cycle ? row->labels.at(label) : ReportSeries::gap);
        chart.series.push_back(std::move(series));
    }
    return chart;
}

ReportChart counts_chart(const evaluation::Drive& drive) {
    ChartRows shown;
    ReportChart chart = chart_of_cycles(drive, shown);
    chart.id = "counts";
    chart.title = "How far the blocks got";
    chart.quantity = "count";
    chart.note =
        "At the end of each cycle, and for every field without motion. Few confident blocks: little texture, "
        "darkness, or motion blur.";
    chart.least_span = 10.0;
    const auto add = [&](const char* name, const Colour& colour, int evaluation::FieldRow::*member) {
        ReportSeries series = {name, colour, false, 1.8, false, {}};
        for (const evaluation::FieldRow* row : shown) series.values.push_back(row->*member);
        chart.series.push_back(std::move(series));
    };
    add("placed", palette::grey, &evaluation::FieldRow::placed);
    add("confident", palette::sky_blue, &evaluation::FieldRow::confident);
    add("supporting the turn rate", palette::green, &evaluation::FieldRow::inliers);
    add("supporting the speed", palette::purple, &evaluation::FieldRow::ground_window);
    add("obstacle points", palette::vermilion, &evaluation::FieldRow::obstacles);
    return chart;
}

ReportTrack track_of(const ReportSeries& look, const evaluation::Drive& drive,
                     const evaluation::PoseTrack& track) {
    ReportTrack result = {look, {}};
    std::optional<Pose2> first;
    for (const evaluation::FieldRow& row : drive.rows) {
        const auto pose = track.ground_at(row.timestamp_s);
        if (pose && !first) first = pose;
        const double unknown = std::nan("");
        result.poses.push_back(pose ? compose(inverse(*first), *pose) : Pose2{unknown, unknown, unknown});
    }
    return result;
}

}  // namespace

std::vector<ReportTrack> report_tracks(const evaluation::Drive& drive) {
    std::vector<ReportTrack> tracks;
    if (!drive.ground_truth.empty()) tracks.push_back(track_of(truth_look, drive, drive.ground_truth));
    if (!drive.odometry.empty()) tracks.push_back(track_of(odometry_look, drive, drive.odometry));
    ReportTrack flow = {flow_look, {}};
    for (const evaluation::FieldRow& row : drive.rows) flow.poses.push_back(row.T_start_robot);
    tracks.push_back(std::move(flow));
    return tracks;
}

std::vector<ReportChart> report_charts(const evaluation::Drive& drive) {
    std::vector<ReportChart> charts = {turn_chart(drive), speed_chart(drive), heading_chart(drive)};
    if (!drive.ground_truth.empty()) charts.push_back(distance_chart(drive));
    charts.push_back(labels_chart(drive));
    charts.push_back(counts_chart(drive));
    for (ReportChart& chart : contact_charts(drive)) charts.push_back(std::move(chart));
    return charts;
}

}  // namespace flownav::report
