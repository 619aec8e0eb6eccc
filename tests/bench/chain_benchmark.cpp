// One field through the chain, and its most expensive part alone.
#include <benchmark/benchmark.h>

#include "flownav/flow/match_blocks.h"
#include "flownav/pipeline/pipeline.h"
#include "sample.h"

namespace flownav::bench {
namespace {

/// 350 blocks (or as many as asked) between two fields of the same parity.
void Match(benchmark::State& state) {
    const auto& fields = sample_fields();
    FlowParams params;
    params.blocks = static_cast<int>(state.range(0));
    const BlockLayout layout = place_blocks(RayMapper(fields[20].camera), params);
    const std::vector<Eigen::Vector2i> bias_px(layout.size(), Eigen::Vector2i::Zero());
    MatchSettings settings;
    settings.threads = static_cast<int>(state.range(1));
    std::vector<FlowVector> vectors;
    while (state.KeepRunning()) {
        match_blocks(fields[20].image, fields[22].image, layout, bias_px, settings, vectors);
        benchmark::DoNotOptimize(vectors.data());
    }
    state.SetLabel(settings.kernel->name);
    state.counters["ns_per_vector"] = benchmark::Counter(
        1e-9 * static_cast<double>(layout.size()) * static_cast<double>(state.iterations()),
        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(Match)->Args({350, 1})->Args({350, 2})->Args({35, 1})->Args({2000, 1})->UseRealTime()->Unit(
    benchmark::kMillisecond);

/// The whole drive; per field: flow, ego-motion, obstacles. A second drive in the same state is the steady
/// one.
void Step(benchmark::State& state) {
    const auto& fields = sample_fields();
    pipeline::Params params;
    params.threads = static_cast<int>(state.range(0));
    while (state.KeepRunning()) {
        pipeline::State chain(params);
        for (const Field& field : fields) benchmark::DoNotOptimize(&pipeline::step(chain, field));
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(fields.size()) * state.iterations());
}
BENCHMARK(Step)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flownav::bench
