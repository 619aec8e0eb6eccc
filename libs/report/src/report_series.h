#pragma once
#include <vector>

#include "flownav/evaluation/drive.h"
#include "flownav/report/chart.h"
#include "flownav/report/label_style.h"

namespace flownav::report {

/// The ways of the robot over the same times, each from the identity on; not a number where not known.
struct ReportTrack {
    ReportSeries look;
    std::vector<Pose2> poses;
};

/// Charts over time: turn rate, forward speed, heading, distance from the truth, blocks by label, counts;
/// with contact scans their strips and the fit of the floor.
std::vector<ReportChart> report_charts(const evaluation::Drive& drive);

/// Flow, odometry and truth, as far as there are any; one pose a field.
std::vector<ReportTrack> report_tracks(const evaluation::Drive& drive);

}  // namespace flownav::report
