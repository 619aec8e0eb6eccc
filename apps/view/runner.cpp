#include "runner.h"

#include "flownav/config/make_state.h"
#include "flownav/evaluation/field_row.h"
#include "flownav/io/note_reading.h"

namespace flownav::view {

std::size_t Checkpoint::bytes() const {
    constexpr std::size_t inflater_bytes = 50'000;
    constexpr std::size_t block_bytes = 1200;  // total of all lists of the pipeline
    const auto image_bytes = static_cast<std::size_t>(frame.field.image.width_px) *
                             static_cast<std::size_t>(frame.field.image.height_px);
    return inflater_bytes + 2 * image_bytes + block_bytes * frame.step.blocks.size();
}

Runner::Runner(const std::filesystem::path& file, const config::Config& config)
    : reader_(std::make_unique<io::RawlogReader>(file)), state_(config::make_state(config)) {
    source_.emplace(*reader_, config.camera, config.input);
}

std::optional<io::ReplayEvent> Runner::next_event() {
    if (!stop_reason_.empty()) return std::nullopt;
    try {
        return source_->next();
    } catch (const config::ConfigError& error) {
        if (next_index_ == 0) throw;
        stop_reason_ = error.what();
        return std::nullopt;
    }
}

bool Runner::advance() {
    poses_.clear();
    while (const auto event = next_event()) {
        io::note_reading(state_, *event);
        if (const auto* sample = std::get_if<io::PoseSample>(&*event)) {
            poses_.push_back(*sample);
        } else if (const auto* field = std::get_if<Field>(&*event)) {
            take(*field);
            return true;
        }
    }
    return false;
}

void Runner::take(const Field& field) {
    // The previous field is the new reference when its step says so.
    if (next_index_ > 0 && evaluation::row_of(frame_.step).starts_reference) frame_.reference = frame_.field;
    frame_.field = field;
    frame_.index = next_index_++;
    frame_.preview = false;
    frame_.step = pipeline::step(state_, field);
    if (frame_.step.image_of_cycle == 0 && frame_.step.status != FieldStatus::BadField) {
        frame_.reference.reset();
    }
    frame_.contacts.take(frame_.step);
    if (!frame_.step.end_of_cycle) return;
    const pipeline::Step& step = frame_.step;
    frame_.last_cycle = std::make_shared<const CycleResult>(
        CycleResult{step.timestamp_s, step.T_start_robot, step.obstacles, step.ground, step.scan});
}

std::shared_ptr<const Checkpoint> Runner::checkpoint() const {
    return std::make_shared<const Checkpoint>(
        Checkpoint{next_index_, reader_->mark(), *source_, state_.clone(), frame_});
}

void Runner::resume(const Checkpoint& checkpoint) {
    reader_->go_to(*checkpoint.place);
    source_.emplace(*reader_, checkpoint.source);
    state_ = checkpoint.state.clone();
    frame_ = checkpoint.frame;
    next_index_ = checkpoint.next_index;
    poses_.clear();
    stop_reason_.clear();
}

void Runner::resume_afresh(const Checkpoint& checkpoint, const config::Config& config) {
    resume(checkpoint);
    state_ = config::make_state(config);
    frame_.reference.reset();
    frame_.last_cycle.reset();
    frame_.contacts = {};
}

void Runner::retry() {
    io::FieldSource before = *source_;
    reader_->go_to(*reader_->mark());
    source_.emplace(*reader_, before);
}

}  // namespace flownav::view
