// Replay of a rawlog: decoding alone, the whole, and memory over a long drive.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "flownav/replay/field_source.h"
#include "flownav/replay/replay.h"
#include "sample.h"

namespace flownav::bench {
namespace {

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Reading and unpacking alone; holds one field at a time.
void Decode(benchmark::State& state) {
    std::int64_t fields = 0;
    while (state.KeepRunning()) {
        RawlogReader reader(sample_rawlog());
        FieldSource source(reader, {});
        while (const auto event = source.next()) fields += std::holds_alternative<Field>(*event);
    }
    state.SetItemsProcessed(fields);
}
BENCHMARK(Decode)->Unit(benchmark::kMillisecond);

/// flownav-replay with all its outputs.
void Replay(benchmark::State& state) {
    ReplayOptions options;
    options.input = sample_rawlog();
    options.output = std::filesystem::temp_directory_path() / "flownav-bench";
    options.config.pipeline.threads = static_cast<int>(state.range(0));
    while (state.KeepRunning()) {
        if (replay(options).status != ExitStatus::Fine) state.SkipWithError("replay failed");
    }
    std::filesystem::remove_all(options.output);
    state.SetItemsProcessed(static_cast<std::int64_t>(sample_fields().size()) * state.iterations());
    state.counters["peak_memory_MB"] = peak_memory_mb();
}
BENCHMARK(Replay)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flownav::bench
