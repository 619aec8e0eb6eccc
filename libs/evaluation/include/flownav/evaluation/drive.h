#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field_status.h"
#include "flownav/evaluation/camera_check.h"
#include "flownav/evaluation/field_row.h"
#include "flownav/evaluation/findings.h"
#include "flownav/evaluation/metrics.h"
#include "flownav/evaluation/pose_track.h"
#include "flownav/evaluation/timing.h"
#include "flownav/io/field_source.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/mapping/export.h"

namespace flownav::evaluation {

/// Counts of the contents of the output files.
struct WrittenCounts {
    std::uint64_t trajectory_poses = 0;
    std::uint64_t odometry_poses = 0;
    std::uint64_t ground_truth_poses = 0;
    std::uint64_t egomotion_rows = 0;
    std::uint64_t obstacle_points = 0;
    std::uint64_t cycles = 0;                            ///< finished cycles, each with a scan and a cloud
    mapping::CellCounts map_cells;                       ///< cells of map.pgm
    std::map<std::string, std::uint64_t> result_rawlog;  ///< number of observations by label
};

/// Results of the replay of a drive.
struct Drive {
    std::string input_name;  ///< file name without its folder
    io::ReadEnd end;
    std::string stop_reason;  ///< reason why reading stopped before the end; empty when it did not
    io::InputCounts read;
    WrittenCounts written;
    std::vector<FieldRow> rows;
    FieldFaultCounts field_faults{};  ///< reasons of the status bad_field
    std::vector<Finding> findings;    ///< of everything that limits the results
    PoseTrack odometry;
    PoseTrack ground_truth;
    std::optional<Errors> odometry_errors;      ///< empty when the rawlog has no odometry
    std::optional<Errors> ground_truth_errors;  ///< empty when the rawlog has no ground truth
    CameraCheck camera_check;
};

/// Kind of the input's end as one word, as written to summary.json.
const char* end_word(const Drive& drive);

/// Kind of the input's end as one sentence.
std::string end_sentence(const Drive& drive);

/// Number of fields with each status, in the order of all_field_statuses.
std::vector<std::uint64_t> status_counts(const std::vector<FieldRow>& rows);

/// Times during which the motion was not measured and the pose was carried over.
struct CarriedTime {
    double total_s = 0.0;
    double longest_s = 0.0;
    double duration_s = 0.0;  ///< duration of the drive
    double sigma_m = 0.0;     ///< standard deviation of the end position caused by carrying over
};
CarriedTime carried_time(const std::vector<FieldRow>& rows);

/// Warning when the carried time exceeds 0.5 s and 2 % of the drive, or `carry_max_s` (as configured) at a
/// stretch; else empty.
std::string carried_warning(const CarriedTime& carried, double carry_max_s);

/// Warning when cycles were left out of the map because the robot was more than `half_m` from the start; else
/// empty.
std::string map_warning(int sets, int sets_outside, double half_m);

/// Everything that limits the results of a drive: what was read, what became of it, what contradicts it, in
/// the order of their weight. Needs all other parts of the drive. `map_warning`: see above.
std::vector<Finding> judge(const Drive& drive, const config::Config& config, const std::string& map_warning);

/// Explanation of a status for reports.
const char* explain(FieldStatus status);

}  // namespace flownav::evaluation
