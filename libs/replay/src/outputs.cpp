#include "flownav/replay/outputs.h"

#include <system_error>

#include "flownav/evaluation/summary.h"
#include "flownav/io/gz_member.h"
#include "flownav/mapping/export.h"
#include "flownav/replay/obstacle_set.h"
#include "flownav/report/report.h"

namespace flownav::replay {

namespace {

constexpr const char* odometry_name = "odometry.tum";
constexpr const char* ground_truth_name = "ground_truth.tum";

/// Creates the folder and removes pose tracks of an earlier replay. Throws OutputError.
std::filesystem::path prepared(std::filesystem::path folder) {
    io::make_output_folder(folder);
    for (const char* name : {odometry_name, ground_truth_name}) {
        std::error_code error;
        std::filesystem::remove(folder / name, error);
        if (error)
            throw io::OutputError("cannot replace " + (folder / name).string() + ": " + error.message());
    }
    return folder;
}

void write_map(const mrpt::maps::COccupancyGridMap2D& grid, const std::filesystem::path& folder,
               const mapping::OccupancyLimits& limits) {
    const mapping::MapFiles files = mapping::export_map(grid, limits);
    io::write_file(folder / "map.pgm", files.pgm);
    io::write_file(folder / "map.yaml", files.yaml);
    const std::vector<std::uint8_t> packed = io::gz_member(files.gridmap);
    io::write_file(folder / "map.gridmap.gz", {reinterpret_cast<const char*>(packed.data()), packed.size()});
}

}  // namespace

const std::vector<const char*>& output_names() {
    static const std::vector<const char*> names = {
        "trajectory.tum", odometry_name, ground_truth_name, "egomotion.csv", "obstacles.csv", "contacts.csv",
        "map.pgm",        "map.yaml",    "map.gridmap.gz",  "result.rawlog", "summary.json",  "report.html"};
    return names;
}

Outputs::Outputs(std::filesystem::path folder, const config::Config& config, const OptionalOutputs& optional)
    : folder_(prepared(std::move(folder))),
      config_(config),
      keep_images_(optional.keep_images),
      trajectory_(folder_ / "trajectory.tum"),
      egomotion_(folder_ / "egomotion.csv"),
      obstacles_(folder_ / "obstacles.csv"),
      contacts_(folder_ / "contacts.csv"),
      rawlog_(folder_ / "result.rawlog", config.pipeline.obstacles.range_max_m),
      map_(config.map) {
    if (!optional.video.empty()) video_.emplace(optional.video, config.map.size_m);
    if (!optional.flow_field.empty()) flow_field_.emplace(optional.flow_field);
}

void Outputs::map(const pipeline::Step& step) {
    if (!is_new_for_map(step)) return;
    copy_surroundings(step, set_);
    map_.insert(set_);
}

void Outputs::write(const Field& field, const pipeline::Step& step) {
    if (keep_images_) rawlog_.write_image(field, config_.camera.camera_label);
    trajectory_.write(step.timestamp_s, step.T_start_robot);
    egomotion_.write(step);
    obstacles_.write(step);
    contacts_.write(step);
    rawlog_.write(step);
    ++written_.trajectory_poses;
    ++written_.egomotion_rows;
    written_.obstacle_points += step.obstacles.size();
    if (step.end_of_cycle) ++written_.cycles;
    if (flow_field_) flow_field_->write(field, step);
    if (video_) video_->write(field, step, map_.grid());
}

void Outputs::finish(evaluation::Drive& drive, const report::ThumbnailStrip& thumbnail_strip,
                     const evaluation::Timing* timing) {
    trajectory_.close();
    egomotion_.close();
    obstacles_.close();
    contacts_.close();
    rawlog_.close();
    if (video_) video_->close();
    if (flow_field_) flow_field_->close();
    written_.result_rawlog = rawlog_.counts();
    written_.odometry_poses = write_track(odometry_name, drive.odometry, drive);
    written_.ground_truth_poses = write_track(ground_truth_name, drive.ground_truth, drive);
    write_map(map_.grid(), folder_, config_.map.occupancy);
    written_.map_cells = mapping::count_cells(map_.grid(), config_.map.occupancy);
    drive.written = written_;
    io::write_file(folder_ / "report.html",
                   report::report_html(drive, thumbnail_strip, map_.grid(), config_, timing));
}

void Outputs::write_summary(const evaluation::Drive& drive, const evaluation::Timing& timing) {
    io::write_file(folder_ / "summary.json", evaluation::summary_json(drive, config_, timing));
}

std::uint64_t Outputs::write_track(const char* name, const evaluation::PoseTrack& track,
                                   const evaluation::Drive& drive) {
    if (track.empty()) return 0;
    const double start_s = drive.rows.empty() ? -HUGE_VAL : drive.rows.front().timestamp_s;
    const auto poses = track.aligned(start_s);
    evaluation::TrajectoryFile file(folder_ / name);
    for (const evaluation::TimedPose& sample : poses) file.write(sample.timestamp_s, sample.pose);
    file.close();
    return poses.size();
}

}  // namespace flownav::replay
