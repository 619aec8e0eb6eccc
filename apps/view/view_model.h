#pragma once
#include <Eigen/Core>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "background_reader.h"
#include "checkpoints.h"
#include "sad_window.h"
#include "timeline.h"

namespace flownav::view {

struct ViewOptions {
    std::filesystem::path input;
    config::Config config;
    BackgroundReader::Way way = BackgroundReader::Way::Thread;
    std::string name;     ///< name to show; empty: that of the file
    bool follow = false;  ///< the rawlog still grows
    /// Limit of the checkpoints; twice that while parameters change.
    std::size_t checkpoint_bytes = 100'000'000;
};

/// The viewer without its window: the shown field, the summary of the drive, the block under the mouse, the
/// parameters. No call blocks for long; long work runs in the background and its results arrive with poll().
class ViewModel {
  public:
    /// Shows the first field. Throws InputError when the file cannot be read, ConfigError when no field can
    /// be used.
    explicit ViewModel(const ViewOptions& options);

    /// Takes in the results of the background. Returns true when the picture has changed.
    bool poll();

    /// For BackgroundReader::Way::Asked: lets the background process `fields` fields. Returns false when
    /// there are no more.
    bool work(std::size_t fields);

    /// Shows field `index`, or the last one read. The result equals flownav-replay's, except for a preview: a
    /// field that has not been computed from the start with the present parameters.
    void show(std::size_t index);

    /// Shows the last field not after `time_s` since the start of the drive.
    void show_at(double time_s);
    void step_by(int fields);

    // Playing
    void set_playing(bool playing);  ///< starts again at the end of the drive
    bool playing() const { return playing_; }
    void set_speed(double speed) { speed_ = speed; }  ///< 1: the speed of the drive
    double speed() const { return speed_; }
    void play_for(double elapsed_s);  ///< advances the playback and shows the field that is due

    // Block under the mouse
    void hover(const std::optional<Eigen::Vector2d>& field_px);  ///< empty: beside the field
    std::optional<std::size_t> hovered_block() const { return hovered_; }
    std::optional<SadWindow> hovered_window() const;

    // Parameters
    const config::Config& config() const { return config_; }
    void set(const std::string& key, const std::string& value);  ///< throws ConfigError

    const Frame& frame() const { return frame_; }
    const Timeline& timeline() const { return timeline_; }
    const io::InputCounts& counts() const { return counts_; }
    const std::string& name() const { return name_; }
    bool follows() const { return options_.follow; }
    std::size_t last_index() const { return timeline_.rows.empty() ? 0 : timeline_.rows.size() - 1; }
    const Checkpoints& checkpoints() const { return checkpoints_; }

    // Stretch for export; both ends are shown fields
    void mark_begin() { begin_ = frame_.index; }
    void mark_end() { end_ = frame_.index; }
    std::pair<std::size_t, std::size_t> stretch() const;  ///< the whole drive when no stretch is marked
    std::optional<std::pair<std::size_t, std::size_t>> marked_stretch() const;

  private:
    void require_field();
    void restart_scout();
    void restart_runner();
    void seek(std::size_t index);
    void seek_preview(std::size_t index);
    void advance_to(std::size_t index);
    void take_frame();
    void find_hovered();
    void take_rows(const BackgroundNews& news);
    void take_poses(const std::vector<io::PoseSample>& poses);

    ViewOptions options_;
    config::Config config_;
    std::string name_;
    Timeline timeline_;
    io::InputCounts counts_;
    Checkpoints checkpoints_;          ///< computed with the present parameters
    Checkpoints earlier_checkpoints_;  ///< of earlier parameters: used as places in the file only
    std::unique_ptr<BackgroundReader> background_reader_;
    Runner runner_;
    /// Pose at which the runner's preview began; empty: the result is exact.
    std::optional<Pose2> T_start_preview_;
    Frame frame_;
    bool playing_ = false;
    double speed_ = 1.0;
    double last_odometry_s_ = -HUGE_VAL, last_truth_s_ = -HUGE_VAL;
    double play_s_ = 0.0;  ///< playback time not yet shown
    std::optional<Eigen::Vector2d> mouse_px_;
    std::optional<std::size_t> hovered_;
    std::optional<std::size_t> begin_, end_;
};

}  // namespace flownav::view
