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
    std::string name;                            ///< to show; empty: that of the file
    bool follow = false;                         ///< the rawlog still grows
    std::size_t checkpoint_bytes = 100'000'000;  ///< twice that while parameters change
};

/// Everything the viewer does, without a window: which field is shown, what is known of the drive, what is
/// under the mouse, what the parameters are. Every call returns soon; whatever takes long runs ahead in the
/// background and comes in with poll().
class ViewModel {
  public:
    /// Shows the first field. Throws InputError: nothing can be read; ConfigError: no field can be used.
    explicit ViewModel(const ViewOptions& options);

    /// Takes in what was found in the background. True when something changed that can be seen.
    bool poll();

    /// For Scout::Way::Asked: lets the background process so many fields; false when there are no more.
    bool work(std::size_t fields);

    /// Shows field `index`, or the last one that is known: exactly as flownav-replay sees it or, where new
    /// parameters have not been tried from the start yet, as a preview.
    void show(std::size_t index);

    /// The same for the last field not after `time_s` from the start of the drive.
    void show_at(double time_s);
    void step_by(int fields);

    // Playing
    void set_playing(bool playing);  ///< from the start when the end is shown
    bool playing() const { return playing_; }
    void set_speed(double speed) { speed_ = speed; }  ///< 1: as fast as the drive was
    double speed() const { return speed_; }
    void play_for(double elapsed_s);  ///< time has passed: shows what is due

    // Looking at a block
    void hover(const std::optional<Eigen::Vector2d>& field_px);  ///< nothing: beside the field
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

    // A stretch for export; both ends are shown fields
    void mark_begin() { begin_ = frame_.index; }
    void mark_end() { end_ = frame_.index; }
    std::pair<std::size_t, std::size_t> stretch() const;  ///< the whole drive when nothing is marked
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
    Checkpoints checkpoints_;          ///< of the present parameters
    Checkpoints earlier_checkpoints_;  ///< of other parameters: good for their places in the file
    std::unique_ptr<BackgroundReader> background_reader_;
    Runner runner_;
    std::optional<Pose2> T_start_preview_;  ///< where the runner's preview began; nothing: it is exact
    Frame frame_;
    bool playing_ = false;
    double speed_ = 1.0;
    double last_odometry_s_ = -HUGE_VAL, last_truth_s_ = -HUGE_VAL;
    double play_s_ = 0.0;  ///< time that is due while playing
    std::optional<Eigen::Vector2d> mouse_px_;
    std::optional<std::size_t> hovered_;
    std::optional<std::size_t> begin_, end_;
};

}  // namespace flownav::view
