#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/field.h"
#include "flownav/evaluation/csv_files.h"
#include "flownav/evaluation/drive.h"
#include "flownav/evaluation/trajectory_file.h"
#include "flownav/io/flow_field_file.h"
#include "flownav/mapping/global_map.h"
#include "flownav/pipeline/step.h"
#include "flownav/replay/result_rawlog.h"
#include "flownav/report/drive_video.h"
#include "flownav/report/thumbnail_strip.h"

namespace flownav::replay {

/// Outputs that are written on request only.
struct OptionalOutputs {
    bool keep_images = false;          ///< copy the fields into result.rawlog too
    std::filesystem::path video;       ///< MP4 file of the drive; empty: none
    std::filesystem::path flow_field;  ///< rawlog of CObservationFlowField; empty: none
};

/// Names of the files that a replay writes into its folder.
const std::vector<const char*>& output_names();

/// Writes the files of an output folder: per-field data at once, results of the whole drive in finish(). All
/// functions throw OutputError.
class Outputs {
  public:
    Outputs(std::filesystem::path folder, const config::Config& config, const OptionalOutputs& optional);

    /// Inserts obstacles and floor of a finished cycle into the map; must be called before write().
    void map(const pipeline::Step& step);
    void write(const Field& field, const pipeline::Step& step);
    const mapping::GlobalMap& global_map() const { return map_; }
    void write_odometry(const io::PoseSample& sample) { rawlog_.write_odometry(sample); }

    /// Writes pose tracks, map and report, and closes all files. The report includes `timing` unless null.
    /// Fills drive.written.
    void finish(evaluation::Drive& drive, const report::ThumbnailStrip& thumbnail_strip,
                const evaluation::Timing* timing = nullptr);

    /// Writes summary.json, with the counts of finish().
    void write_summary(const evaluation::Drive& drive, const evaluation::Timing& timing);

  private:
    std::uint64_t write_track(const char* name, const evaluation::PoseTrack& track,
                              const evaluation::Drive& drive);

    std::filesystem::path folder_;
    config::Config config_;
    bool keep_images_;
    evaluation::WrittenCounts written_;
    evaluation::TrajectoryFile trajectory_;
    evaluation::EgomotionCsv egomotion_;
    evaluation::ObstaclesCsv obstacles_;
    evaluation::ContactsCsv contacts_;
    ResultRawlog rawlog_;
    mapping::GlobalMap map_;
    mapping::ObstacleSet set_;  ///< reused to avoid allocations
    std::optional<report::DriveVideo> video_;
    std::optional<io::FlowFieldFile> flow_field_;
};

}  // namespace flownav::replay
