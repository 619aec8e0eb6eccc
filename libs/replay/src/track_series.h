#pragma once
#include <functional>
#include <optional>

#include "flownav/replay/drive.h"
#include "flownav/replay/svg_chart.h"

namespace flownav {

/// A track on the ground over the time of a drive, in the frame of its pose at the first field.
struct GroundTrack {
    std::vector<double> timestamps_s;
    std::vector<Pose2> poses;
    std::vector<double> unwrapped_rad;  ///< headings without jumps at half a turn
};

GroundTrack flow_track(const Drive& drive);
GroundTrack ground_track(const Drive& drive, const PoseTrack& track);

/// What a field adds to a curve, if anything.
using FieldValue = std::function<std::optional<double>(const FieldRow&)>;

/// `look` with a point for each row that has a value. Gaps of more fields than `drawn_through` stay open,
/// unless they are too short to be seen.
ChartSeries over_time(ChartSeries look, const Drive& drive, const FieldValue& value,
                      double drawn_through = 3.0);

/// `look` with the way of a track seen from above.
ChartSeries plan(ChartSeries look, const GroundTrack& track);

/// `look` with the heading of a track in degrees.
ChartSeries heading(ChartSeries look, const GroundTrack& track, double start_s);

/// `look` with a rate of another track: `component` of the motion from one field to the next, per second.
ChartSeries rate(ChartSeries look, const Drive& drive, const PoseTrack& track,
                 const std::function<double(const Pose2&)>& component);

}  // namespace flownav
