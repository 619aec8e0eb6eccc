#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "flownav/evaluation/field_row.h"
#include "flownav/evaluation/pose_track.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::view {

/// An obstacle point in the frame of the start of the drive.
struct MapPoint {
    std::size_t index = 0;  ///< index of the field that ended its cycle
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    bool moving = false;
};

/// Summary of every field of a drive.
struct Timeline {
    std::vector<evaluation::FieldRow> rows;  ///< by index
    std::size_t current = 0;       ///< rows before this index were computed with the present parameters
    std::vector<MapPoint> points;  ///< points of the present parameters, by rising index
    std::vector<MapPoint> earlier_points;  ///< points of earlier parameters; valid from index `current` on
    evaluation::PoseTrack odometry;
    evaluation::PoseTrack ground_truth;
    bool complete = false;    ///< all readable data has been read
    io::ReadEnd end;          ///< valid when complete
    std::string stop_reason;  ///< why reading stopped before the end; empty otherwise
    double progress = 0.0;    ///< share of the file that has been read, 0..1

    double time_s(std::size_t index) const { return rows[index].timestamp_s - rows.front().timestamp_s; }

    /// Index of the last field not after `time_s` since the start; 0 when there is none. `rows` must not be
    /// empty.
    std::size_t index_at(double time_s) const;

    /// Message about the end of the file; empty while reading, and at a clean end.
    std::string end_text() const;
};

}  // namespace flownav::view
