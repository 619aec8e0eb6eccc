#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "flownav/evaluation/field_row.h"
#include "flownav/evaluation/pose_track.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::view {

/// An obstacle point where it stood, in the frame of the start of the drive.
struct MapPoint {
    std::size_t index = 0;  ///< of the field that ended its cycle
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    bool moving = false;
};

/// The little that is kept of every field of a drive.
struct Timeline {
    std::vector<evaluation::FieldRow> rows;  ///< by index
    std::size_t current = 0;                 ///< rows before this index are of the present parameters
    std::vector<MapPoint> points;            ///< of the present parameters, by rising index
    std::vector<MapPoint> earlier_points;    ///< of earlier parameters: those from `current` on count
    evaluation::PoseTrack odometry;
    evaluation::PoseTrack ground_truth;
    bool complete = false;    ///< all that can be read has been read
    io::ReadEnd end;          ///< when complete
    std::string stop_reason;  ///< why reading stopped before the end; empty when it did not
    double progress = 0.0;    ///< share of the file that has been read, 0..1

    double time_s(std::size_t index) const { return rows[index].timestamp_s - rows.front().timestamp_s; }

    /// The last field not after `time_s` from the start; the first when there is none. rows must not be
    /// empty.
    std::size_t index_at(double time_s) const;

    /// What a person wants to know of how the file ends; empty while reading, and at a clean end.
    std::string end_text() const;
};

}  // namespace flownav::view
