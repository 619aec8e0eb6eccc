#include "view_model.h"

#include <algorithm>
#include <cmath>

namespace flownav::view {

namespace {

constexpr double preview_s = 1.0;  // length of the drive that is recomputed for a preview
constexpr double half_block_px = flow::block_px / 2.0;

/// Pixel at which a block is drawn.
Eigen::Vector2d shown_px(const pipeline::BlockRecord& block) {
    const bool moved = block.vector.valid && block.label != BlockLabel::Sifted;
    return moved ? block.vector.at_px + block.vector.flow_px : block.vector.at_px;
}

/// False for blocks without a recorded place.
bool has_place(const pipeline::BlockRecord& block) {
    return block.vector.at_px.x() > 0.0;
}

}  // namespace

ViewModel::ViewModel(const ViewOptions& options)
    : options_(options),
      config_(options.config),
      name_(options.name.empty() ? options.input.filename().string() : options.name),
      checkpoints_(options.checkpoint_bytes),
      earlier_checkpoints_(options.checkpoint_bytes),
      runner_(options.input, options.config) {
    require_field();
    take_frame();
    restart_scout();
    poll();
}

void ViewModel::require_field() {
    if (runner_.advance()) return;
    counts_ = runner_.counts();
    if (runner_.end().kind != io::ReadEnd::Kind::Clean) throw io::InputError(runner_.end().message);
    throw config::ConfigError(
        io::why_no_field(counts_, options_.input.string(), config_.camera.camera_label));
}

void ViewModel::restart_scout() {
    background_reader_.reset();  // only one reader runs at a time
    background_reader_ =
        std::make_unique<BackgroundReader>(options_.input, config_, options_.way, options_.follow);
    background_reader_->set_stride(checkpoints_.stride());
}

bool ViewModel::work(std::size_t fields) {
    return background_reader_->work(fields);
}

bool ViewModel::poll() {
    const BackgroundNews news = background_reader_->take();
    for (const auto& checkpoint : news.checkpoints) checkpoints_.add(checkpoint);
    background_reader_->set_stride(checkpoints_.stride());
    take_poses(news.poses);
    take_rows(news);
    // The end of a growing file is not final.
    const bool complete = news.complete && (!options_.follow || !news.failure.empty());
    const bool changed = !news.rows.empty() || complete != timeline_.complete;
    timeline_.complete = complete;
    timeline_.end = news.end;
    timeline_.stop_reason = news.failure.empty() ? news.stop_reason : news.failure;
    timeline_.progress = news.progress;
    if (news.complete) counts_ = news.counts;
    if (frame_.preview && frame_.index < timeline_.current) show(frame_.index);
    return changed;
}

void ViewModel::take_rows(const BackgroundNews& news) {
    for (const evaluation::FieldRow& row : news.rows) {
        if (timeline_.current < timeline_.rows.size()) {
            timeline_.rows[timeline_.current] = row;
        } else {
            timeline_.rows.push_back(row);
        }
        ++timeline_.current;
    }
    timeline_.points.insert(timeline_.points.end(), news.points.begin(), news.points.end());
}

void ViewModel::take_poses(const std::vector<io::PoseSample>& poses) {
    for (const io::PoseSample& sample : poses) {
        const bool truth = sample.source == io::PoseSample::Source::GroundTruth;
        double& last_s = truth ? last_truth_s_ : last_odometry_s_;
        if (sample.timestamp_s <= last_s) continue;  // already known from a run with other parameters
        last_s = sample.timestamp_s;
        (truth ? timeline_.ground_truth : timeline_.odometry).add(sample.timestamp_s, sample.pose);
    }
    if (poses.empty()) return;
    timeline_.ground_truth.finish();
    timeline_.odometry.finish();
}

void ViewModel::show(std::size_t index) {
    if (!timeline_.rows.empty()) {
        index = std::min(index, timeline_.rows.size() - 1);
    } else {
        index = 0;
    }
    const bool exact = index < timeline_.current || timeline_.rows.empty();
    if (exact && index == frame_.index && !frame_.preview) return;
    if (exact) {
        seek(index);
    } else {
        seek_preview(index);
    }
    take_frame();
}

void ViewModel::show_at(double time_s) {
    show(timeline_.rows.empty() ? 0 : timeline_.index_at(time_s));
}

void ViewModel::step_by(int fields) {
    playing_ = false;
    const auto at = static_cast<std::ptrdiff_t>(frame_.index) + fields;
    show(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, at)));
}

void ViewModel::advance_to(std::size_t index) {
    while (runner_.next_index() <= index && runner_.advance()) {
    }
}

void ViewModel::seek(std::size_t index) {
    const auto checkpoint = checkpoints_.before(index);
    const bool usable = !T_start_preview_ && runner_.next_index() <= index + 1;
    const bool there = usable && runner_.next_index() == index + 1;
    const bool nearer = checkpoint && checkpoint->next_index > runner_.next_index();
    if (checkpoint && !there && (!usable || nearer)) {
        runner_.resume(*checkpoint);
        T_start_preview_.reset();
    }
    advance_to(index);
}

void ViewModel::seek_preview(std::size_t index) {
    const bool continues = T_start_preview_ && runner_.next_index() == index;
    if (!continues) {
        const std::size_t from = timeline_.index_at(timeline_.time_s(index) - preview_s);
        auto checkpoint = checkpoints_.before(from);
        const auto earlier = earlier_checkpoints_.before(from);
        if (earlier && (!checkpoint || earlier->next_index > checkpoint->next_index)) checkpoint = earlier;
        runner_.resume_afresh(*checkpoint, config_);
        T_start_preview_ = timeline_.rows[checkpoint->next_index].T_start_robot;
    }
    advance_to(index);
}

void ViewModel::take_frame() {
    frame_ = runner_.frame();
    if (T_start_preview_) {
        frame_.preview = true;
        frame_.step.T_start_robot = compose(*T_start_preview_, frame_.step.T_start_robot);
        if (frame_.last_cycle) {
            CycleResult moved = *frame_.last_cycle;
            moved.T_start_robot = compose(*T_start_preview_, moved.T_start_robot);
            frame_.last_cycle = std::make_shared<const CycleResult>(std::move(moved));
        }
    }
    find_hovered();
}

void ViewModel::set_playing(bool playing) {
    playing_ = playing;
    if (timeline_.rows.empty()) return;
    if (playing && frame_.index + 1 == timeline_.rows.size() && timeline_.complete) show(0);
    play_s_ = timeline_.time_s(frame_.index);
}

void ViewModel::play_for(double elapsed_s) {
    if (!playing_ || timeline_.rows.empty()) return;
    const std::size_t last = timeline_.rows.size() - 1;
    play_s_ = std::min(play_s_ + elapsed_s * speed_, timeline_.time_s(last));
    show_at(play_s_);
    if (frame_.index == last && timeline_.complete && !options_.follow) playing_ = false;
}

void ViewModel::hover(const std::optional<Eigen::Vector2d>& field_px) {
    mouse_px_ = field_px;
    find_hovered();
}

void ViewModel::find_hovered() {
    hovered_.reset();
    if (!mouse_px_) return;
    double nearest_px = half_block_px;
    for (std::size_t i = 0; i < frame_.step.blocks.size(); ++i) {
        const pipeline::BlockRecord& block = frame_.step.blocks[i];
        const double distance_px = (shown_px(block) - *mouse_px_).cwiseAbs().maxCoeff();
        if (!has_place(block) || distance_px >= nearest_px) continue;
        nearest_px = distance_px;
        hovered_ = i;
    }
}

std::optional<SadWindow> ViewModel::hovered_window() const {
    return hovered_ ? sad_window(frame_, *hovered_, config_.pipeline.flow) : std::nullopt;
}

void ViewModel::set(const std::string& key, const std::string& value) {
    config::Config changed = config_;
    config::set_config_value(changed, key, value);
    config_ = changed;
    // Keeps the set of checkpoints that reaches farther, as places in the file.
    if (checkpoints_.size() >= earlier_checkpoints_.size()) earlier_checkpoints_ = std::move(checkpoints_);
    checkpoints_ = Checkpoints(options_.checkpoint_bytes);
    if (timeline_.current > 0) {
        auto& kept = timeline_.earlier_points;
        const auto known = std::partition_point(
            kept.begin(), kept.end(), [this](const MapPoint& p) { return p.index < timeline_.current; });
        std::vector<MapPoint> all = std::move(timeline_.points);
        all.insert(all.end(), known, kept.end());
        kept = std::move(all);
    }
    timeline_.points.clear();
    timeline_.current = 0;
    timeline_.complete = false;
    restart_scout();
    poll();
    if (timeline_.rows.empty()) return restart_runner();
    seek_preview(frame_.index);
    take_frame();
}

void ViewModel::restart_runner() {
    runner_.resume(*checkpoints_.before(0));
    T_start_preview_.reset();
    advance_to(frame_.index);
    take_frame();
}

std::pair<std::size_t, std::size_t> ViewModel::stretch() const {
    const std::size_t last = timeline_.rows.empty() ? frame_.index : timeline_.rows.size() - 1;
    const std::size_t from = begin_.value_or(0);
    const std::size_t to = end_.value_or(last);
    return {std::min(from, to), std::max(from, to)};
}

std::optional<std::pair<std::size_t, std::size_t>> ViewModel::marked_stretch() const {
    if (!begin_ && !end_) return std::nullopt;
    return stretch();
}

}  // namespace flownav::view
