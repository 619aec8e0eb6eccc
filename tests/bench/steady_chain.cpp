#include "steady_chain.h"

#include <utility>

namespace flownav::bench {
namespace {

constexpr double pause_s = 10.0;

pipeline::Params with_threads(int threads) {
    pipeline::Params params;
    params.threads = threads;
    return params;
}

}  // namespace

SteadyChain::SteadyChain(const std::vector<Field>& fields, const KernelEntry& kernel, int threads)
    : fields_(fields), state_(with_threads(threads), timed(BlockMatcher(FlowParams(), threads, kernel))) {}

void SteadyChain::drive(const std::function<void(const pipeline::Step&)>& see) {
    const double later_s = fields_.back().timestamp_s - fields_.front().timestamp_s + pause_s;
    for (Field& field : fields_) {
        see(pipeline::step(state_, field));
        field.timestamp_s += later_s;
    }
}

Matcher SteadyChain::timed(Matcher matcher) {
    return [this, matcher = std::move(matcher)](
               const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
               const std::vector<Eigen::Vector2d>& predicted_px, std::vector<FlowVector>& vectors) {
        const auto start = std::chrono::steady_clock::now();
        matcher(reference, newer, layout, predicted_px, vectors);
        match_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
}

}  // namespace flownav::bench
