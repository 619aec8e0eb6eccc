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
#include "flownav/mapping/fusion.h"
#include "flownav/pipeline/step.h"
#include "flownav/replay/result_rawlog.h"
#include "flownav/report/drive_video.h"
#include "flownav/report/filmstrip.h"

namespace flownav {

/// What is written only when asked for.
struct OptionalOutputs {
    bool keep_images = false;          ///< copy the fields into result.rawlog too
    std::filesystem::path video;       ///< an MP4 of the drive; empty: none
    std::filesystem::path flow_field;  ///< a rawlog of CObservationFlowField; empty: none
};

/// Names of the files that every replay writes into its folder.
const std::vector<const char*>& output_names();

/// Every file of an output folder. What is known is written at once; finish() adds what needs the whole
/// drive. Everything throws OutputError when it cannot be written.
class Outputs {
  public:
    Outputs(std::filesystem::path folder, const Config& config, const OptionalOutputs& optional);

    /// Enters what a finished cycle saw into the map; comes before write().
    void map(const pipeline::Step& step);
    void write(const Field& field, const pipeline::Step& step);
    const DriveMap& drive_map() const { return map_; }
    void write_odometry(const PoseSample& sample) { rawlog_.write_odometry(sample); }

    /// Pose tracks, map and report, with `timing` in it unless null; fills drive.written.
    void finish(Drive& drive, const Filmstrip& filmstrip, const Timing* timing = nullptr);

    /// summary.json, which counts what finish() wrote.
    void write_summary(const Drive& drive, const Timing& timing);

  private:
    std::uint64_t write_track(const char* name, const PoseTrack& track, const Drive& drive);

    std::filesystem::path folder_;
    Config config_;
    bool keep_images_;
    WrittenCounts written_;
    TrajectoryFile trajectory_;
    EgomotionCsv egomotion_;
    ObstaclesCsv obstacles_;
    ResultRawlog rawlog_;
    DriveMap map_;
    std::optional<DriveVideo> video_;
    std::optional<FlowFieldFile> flow_field_;
};

}  // namespace flownav
