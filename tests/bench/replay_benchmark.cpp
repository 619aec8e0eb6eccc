// Measures the replay of rawlogs: reading and decoding alone, and the whole replay with all outputs.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>

#include "benchmarks.h"
#include "flownav/cli/exit_status.h"
#include "flownav/io/field_source.h"
#include "flownav/replay/replay.h"
#include "sample.h"

namespace flownav::bench {
namespace {

namespace fs = std::filesystem;

/// The recordings of $FLOWNAV_BENCH_RECORDINGS, written by flownav-bench-recordings, or the sample.
std::vector<fs::path> recordings() {
    const char* folder = std::getenv("FLOWNAV_BENCH_RECORDINGS");
    if (folder == nullptr) return {sample_rawlog()};
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".rawlog" && entry.path().stem() != "long")
            found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

/// Size of the rawlog and its external images.
double size_mb(const fs::path& rawlog) {
    double bytes = static_cast<double>(fs::file_size(rawlog));
    const fs::path images = rawlog.parent_path() / (rawlog.stem().string() + "_Images");
    if (fs::exists(images))
        for (const auto& entry : fs::directory_iterator(images))
            bytes += static_cast<double>(entry.file_size());
    return bytes / 1e6;
}

/// Decodes the rawlog with one field in memory at a time.
void time_decode(benchmark::State& state, const fs::path& rawlog) {
    std::size_t fields = 0;
    while (state.KeepRunning()) {
        fields = 0;
        io::RawlogReader reader(rawlog);
        io::FieldSource source(reader, {});
        while (const auto event = source.next()) fields += std::holds_alternative<Field>(*event) ? 1 : 0;
    }
    state.counters["fields"] = static_cast<double>(fields);
    state.counters["size_MB"] = size_mb(rawlog);
}

void time_replay(benchmark::State& state, const fs::path& rawlog, int threads) {
    replay::ReplayOptions options;
    options.input = rawlog;
    options.output = fs::temp_directory_path() / "flownav-bench";
    options.config.pipeline.threads = threads;
    while (state.KeepRunning()) {
        const replay::ReplayResult result = replay::replay(options);
        if (result.status != cli::ExitStatus::Fine) state.SkipWithError(result.message.c_str());
    }
    fs::remove_all(options.output);
    state.counters["fields"] = static_cast<double>(read_fields(rawlog).size());
}

}  // namespace

void register_replays() {
    for (const fs::path& rawlog : recordings()) {
        const std::string name = rawlog.stem();
        benchmark::RegisterBenchmark(("decode/" + name).c_str(), time_decode, rawlog);
        for (const int threads : {1, 2})
            benchmark::RegisterBenchmark(("replay/" + name + "/threads-" + std::to_string(threads)).c_str(),
                                         time_replay, rawlog, threads)
                ->UseRealTime();
    }
}

}  // namespace flownav::bench
