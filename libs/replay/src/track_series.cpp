#include "track_series.h"

#include <algorithm>
#include <cmath>

namespace flownav {

namespace {

constexpr double visible_gaps = 500.0;  ///< gaps shorter than a drive's duration over this cannot be seen

double to_deg(double angle_rad) {
    return angle_rad * 180.0 / M_PI;
}

void append(GroundTrack& track, double timestamp_s, const Pose2& pose) {
    const double before_rad = track.unwrapped_rad.empty() ? 0.0 : track.unwrapped_rad.back();
    track.timestamps_s.push_back(timestamp_s);
    track.poses.push_back(pose);
    track.unwrapped_rad.push_back(before_rad + wrap_angle(pose.yaw_rad - before_rad));
}

}  // namespace

GroundTrack flow_track(const Drive& drive) {
    GroundTrack result;
    for (const FieldRow& row : drive.rows) append(result, row.timestamp_s, row.T_start_robot);
    return result;
}

GroundTrack ground_track(const Drive& drive, const PoseTrack& track) {
    GroundTrack result;
    if (drive.rows.empty()) return result;
    for (const TimedPose& sample : track.aligned(drive.rows.front().timestamp_s)) {
        if (sample.timestamp_s > drive.rows.back().timestamp_s) break;
        append(result, sample.timestamp_s, {sample.pose.x, sample.pose.y, sample.pose.yaw});
    }
    return result;
}

ChartSeries over_time(ChartSeries look, const Drive& drive, const FieldValue& value, double drawn_through) {
    if (drive.rows.empty()) return look;
    const double start_s = drive.rows.front().timestamp_s;
    const double duration_s = drive.rows.back().timestamp_s - start_s;
    const auto fields = static_cast<double>(drive.rows.size());
    const double gap_s = std::max(drawn_through * duration_s / fields, duration_s / visible_gaps);
    double last_s = -HUGE_VAL;
    for (const FieldRow& row : drive.rows) {
        const auto y = value(row);
        if (!y) continue;
        if (row.timestamp_s - last_s > gap_s) look.pieces.emplace_back();
        look.pieces.back().emplace_back(row.timestamp_s - start_s, *y);
        last_s = row.timestamp_s;
    }
    return look;
}

ChartSeries plan(ChartSeries look, const GroundTrack& track) {
    if (!track.poses.empty()) look.pieces.emplace_back();
    for (const Pose2& pose : track.poses) look.pieces.back().emplace_back(pose.x_m, pose.y_m);
    return look;
}

ChartSeries heading(ChartSeries look, const GroundTrack& track, double start_s) {
    if (!track.poses.empty()) look.pieces.emplace_back();
    for (std::size_t i = 0; i < track.poses.size(); ++i) {
        look.pieces.back().emplace_back(track.timestamps_s[i] - start_s, to_deg(track.unwrapped_rad[i]));
    }
    return look;
}

ChartSeries rate(ChartSeries look, const Drive& drive, const PoseTrack& track,
                 const std::function<double(const Pose2&)>& component) {
    std::optional<Pose2> before;
    double before_s = 0.0;
    const auto value = [&](const FieldRow& row) {
        const auto now = track.ground_at(row.timestamp_s);
        std::optional<double> result;
        if (now && before) result = component(compose(inverse(*before), *now)) / (row.timestamp_s - before_s);
        before = now;
        before_s = row.timestamp_s;
        return result;
    };
    return over_time(std::move(look), drive, value);
}

}  // namespace flownav
