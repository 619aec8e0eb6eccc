#include "flownav/evaluation/profiler.h"

#include <utility>

namespace flownav::evaluation {

namespace {

using Seconds = std::chrono::duration<double>;

void add(StageTimes& sum, const StageTimes& more) {
    for (const NamedStage& stage : all_stages) sum.*stage.seconds += more.*stage.seconds;
}

}  // namespace

void Profiler::enter(Stage stage) {
    const auto now = Clock::now();
    if (stage_ != other) since_field_.*stage_ += Seconds(now - entered_).count();
    stage_ = stage;
    entered_ = now;
}

void Profiler::end_field(double timestamp_s) {
    enter(other);
    fields_.push_back({timestamp_s, std::exchange(since_field_, {})});
}

flow::Matcher Profiler::timed(flow::Matcher matcher) {
    return [this, matcher = std::move(matcher)](
               const ImageView& reference, const ImageView& newer, const flow::BlockLayout& layout,
               const std::vector<Eigen::Vector2d>& predicted_px, std::vector<FlowVector>& vectors) {
        enter(&StageTimes::match_s);
        matcher(reference, newer, layout, predicted_px, vectors);
        enter(&StageTimes::motion_s);
    };
}

void Profiler::report(Timing& timing) {
    enter(stage_);
    timing.stages = since_field_;
    for (const FieldTimes& field : fields_) add(timing.stages, field.spent);
    timing.fields = fields_;
    timing.total_s = Seconds(Clock::now() - start_).count();
}

}  // namespace flownav::evaluation
