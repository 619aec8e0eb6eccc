// Measures every kernel of the table, beside the limit of its instruction.
#include <benchmark/benchmark.h>

#include "benchmarks.h"
#include "flownav/flow/block_layout.h"
#include "known_flow.h"
#include "throughput.h"

namespace flownav::bench {
namespace {

/// Blocks whose whole windows lie inside the image, as many as in the layout: the first ones are repeated.
std::vector<Eigen::Vector2i> whole_blocks(const FlowPair& pair) {
    std::vector<Eigen::Vector2i> blocks;
    for (const Eigen::Vector2i& at : pair.layout.corner_px) {
        const bool whole = at.x() + flow::search_min >= 0 && at.y() + flow::search_min >= 0 &&
                           at.x() + flow::search_max + flow::block_px <= pair.newer.width_px &&
                           at.y() + flow::search_max + flow::block_px <= pair.newer.height_px;
        if (whole) blocks.push_back(at);
    }
    const std::size_t n = blocks.size();
    for (std::size_t i = 0; n > 0 && blocks.size() < pair.layout.size(); ++i) blocks.push_back(blocks[i % n]);
    return blocks;
}

/// Times the kernel alone, over the blocks of a field.
void time_kernel(benchmark::State& state, const flow::KernelEntry& kernel) {
    const FlowPair& pair = rendered_case().pairs.front();
    const auto blocks = whole_blocks(pair);
    const ImageView from = pair.reference.view();
    const ImageView to = pair.newer.view();
    while (state.KeepRunning()) {
        for (const Eigen::Vector2i& at : blocks)
            benchmark::DoNotOptimize(kernel.match(from.row(at.y()) + at.x(), from.stride_bytes,
                                                  to.row(at.y()) + at.x(), to.stride_bytes,
                                                  flow::SearchRange{}));
    }
    state.counters["vectors"] = static_cast<double>(blocks.size());
}

void time_throughput(benchmark::State& state, const Throughput& limit) {
    constexpr std::int64_t iterations = 20000;
    while (state.KeepRunning()) limit.run(iterations);
    state.SetLabel(limit.instruction);
    state.counters["vectors"] = static_cast<double>(iterations * throughput_unrolled) / limit.per_vector;
    state.counters["instructions"] = static_cast<double>(iterations * throughput_unrolled);
}

}  // namespace

void for_each_kernel(const std::function<void(const flow::KernelEntry&)>& enter) {
    for (const flow::KernelEntry& kernel : flow::kernel_table())
        if (kernel.supported()) enter(kernel);
}

std::string kernel_names(bool supported) {
    std::string names;
    for (const flow::KernelEntry& kernel : flow::kernel_table())
        if (kernel.supported() == supported) names += (names.empty() ? "" : " ") + std::string(kernel.name);
    return names;
}

void register_kernels() {
    for_each_kernel([](const flow::KernelEntry& kernel) {
        benchmark::RegisterBenchmark((std::string("kernel/") + kernel.name).c_str(), time_kernel, kernel);
    });
    for (const Throughput& limit : throughput_table())
        if (limit.supported())
            benchmark::RegisterBenchmark((std::string("limit/") + limit.kernel).c_str(), time_throughput,
                                         limit);
}

}  // namespace flownav::bench
