#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field_status.h"
#include "flownav/evaluation/camera_check.h"
#include "flownav/evaluation/field_row.h"
#include "flownav/evaluation/metrics.h"
#include "flownav/evaluation/pose_track.h"
#include "flownav/evaluation/timing.h"
#include "flownav/io/field_source.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/mapping/export.h"

namespace flownav::evaluation {

/// What went into the output files.
struct WrittenCounts {
    std::uint64_t trajectory_poses = 0;
    std::uint64_t odometry_poses = 0;
    std::uint64_t ground_truth_poses = 0;
    std::uint64_t egomotion_rows = 0;
    std::uint64_t obstacle_points = 0;
    std::uint64_t cycles = 0;                            ///< finished cycles, each a scan and a cloud
    mapping::CellCounts map_cells;                       ///< of map.pgm
    std::map<std::string, std::uint64_t> result_rawlog;  ///< observations by label
};

/// Everything that is known when a drive has been replayed.
struct Drive {
    std::string input_name;  ///< of the file, without its folder
    io::ReadEnd end;
    std::string stop_reason;  ///< why reading stopped before the end; empty when it did not
    io::InputCounts read;
    WrittenCounts written;
    std::vector<FieldRow> rows;
    FieldFaultCounts field_faults{};    ///< why fields had the status bad_field
    std::vector<std::string> warnings;  ///< about results that are less than they seem, for people
    PoseTrack odometry;
    PoseTrack ground_truth;
    std::optional<Errors> odometry_errors;      ///< empty when the rawlog has no odometry
    std::optional<Errors> ground_truth_errors;  ///< empty when the rawlog has no ground truth
    CameraCheck camera_check;
};

/// How the input ended, in one word, as summary.json has it.
const char* end_word(const Drive& drive);

/// How the input ended, in one sentence for people.
std::string end_sentence(const Drive& drive);

/// How many fields had each status, in the order of all_field_statuses.
std::vector<std::uint64_t> status_counts(const std::vector<FieldRow>& rows);

/// How long the motion was not measured and the pose was carried over.
struct CarriedTime {
    double total_s = 0.0;
    double longest_s = 0.0;
    double duration_s = 0.0;  ///< of the drive
    double sigma_m = 0.0;     ///< of the end position, by that
};
CarriedTime carried_time(const std::vector<FieldRow>& rows);

/// One sentence when that is more than a few per cent of the drive; else empty. `carry_max_s`: as configured.
std::string carried_warning(const CarriedTime& carried, double carry_max_s);

/// One sentence when cycles were left out of the map because the robot was too far from the start; else
/// empty.
std::string map_warning(int sets, int sets_outside, double half_m);

/// What a status means and what to do about it, for people.
const char* explain(FieldStatus status);

}  // namespace flownav::evaluation
