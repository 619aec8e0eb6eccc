#include "steady_chain.h"

#include <algorithm>
#include <utility>

namespace flownav::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double pause_s = 10.0;
constexpr std::size_t searched_fields = 10;  // first fields of a drive, in which the motion is searched for

pipeline::Params with_threads(int threads) {
    pipeline::Params params;
    params.threads = threads;
    return params;
}

double since_s(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

SteadyChain::SteadyChain(const std::vector<Field>& fields, const flow::KernelEntry& kernel, int threads)
    : fields_(fields),
      state_(with_threads(threads), timed(flow::BlockMatcher(flow::FlowParams(), threads, kernel))) {}

std::size_t SteadyChain::timed_fields() const {
    return fields_.size() - searched_fields;
}

double SteadyChain::drive(const std::function<void(const pipeline::Step&)>& see) {
    double sum_s = 0.0;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const Field field = written(fields_[i]);
        counts_ = i >= searched_fields;
        const Clock::time_point start = Clock::now();
        const pipeline::Step& step = pipeline::step(state_, field);
        see(step);
        if (!counts_) continue;
        sum_s += since_s(start);
        ++driven_;
        ok_ += step.status == FieldStatus::Ok ? 1 : 0;
    }
    later_s_ += fields_.back().timestamp_s - fields_.front().timestamp_s + pause_s;
    return sum_s;
}

Field SteadyChain::written(const Field& field) {
    auto free =
        std::find_if(buffers_.begin(), buffers_.end(), [](const auto& b) { return b.use_count() == 1; });
    const ImageView& from = field.image;
    const auto width = static_cast<std::size_t>(from.width_px);
    if (free == buffers_.end())
        free =
            buffers_.insert(free, std::make_shared<Buffer>(width * static_cast<std::size_t>(from.height_px)));
    for (int v = 0; v < from.height_px; ++v)
        std::copy_n(from.row(v), width, (*free)->begin() + static_cast<std::ptrdiff_t>(width) * v);
    Field copy = field;
    copy.timestamp_s += later_s_;
    copy.image = {(*free)->data(), from.width_px, from.height_px, from.width_px};
    copy.owner = *free;
    return copy;
}

flow::Matcher SteadyChain::timed(flow::Matcher matcher) {
    return [this, matcher = std::move(matcher)](
               const ImageView& reference, const ImageView& newer, const flow::BlockLayout& layout,
               const std::vector<Eigen::Vector2d>& predicted_px, std::vector<FlowVector>& vectors) {
        const Clock::time_point start = Clock::now();
        matcher(reference, newer, layout, predicted_px, vectors);
        if (counts_) match_s_ += since_s(start);
    };
}

}  // namespace flownav::bench
