// Time as a function of vectors, image size and search window, on one thread and two.
#include <benchmark/benchmark.h>

#include <map>

#include "benchmarks.h"
#include "flownav/flow/match_blocks.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/presets.h"
#include "steady_chain.h"

namespace flownav::bench {
namespace {

struct Size {
    int width_px, height_px;
};
constexpr Size pal{768, 288};

constexpr int drive_fields = 20;

/// The same drive at another image size with the same amount of texture; every size is rendered separately.
std::vector<Field> rendered(const Size& size) {
    testing::SceneOptions options = testing::common_preset(1);
    options.camera = testing::field_camera(testing::standard_camera(size.width_px, 2 * size.height_px),
                                           testing::Parity::Top);
    options.images = drive_fields;
    const testing::Scene scene = testing::make_scene(options);
    std::vector<Field> fields;
    for (int i = 0; i < drive_fields; ++i) fields.push_back(testing::make_field(scene, i));
    return fields;
}

const std::vector<Field>& fields_of(const Size& size) {
    static std::map<int, std::vector<Field>> of_width;
    const auto found = of_width.find(size.width_px);
    return found != of_width.end() ? found->second
                                   : of_width.emplace(size.width_px, rendered(size)).first->second;
}

flow::BlockLayout layout_of(const Field& field, int blocks) {
    flow::FlowParams params;
    params.blocks = blocks;
    return flow::place_blocks(RayMapper(field.camera), params);
}

void time_match(benchmark::State& state, Size size, int blocks, int threads) {
    const auto& fields = fields_of(size);
    const flow::BlockLayout layout = layout_of(fields[0], blocks);
    const std::vector<Eigen::Vector2i> bias_px(layout.size(), Eigen::Vector2i::Zero());
    flow::MatchSettings settings;
    settings.threads = threads;
    std::vector<FlowVector> vectors;
    while (state.KeepRunning()) {
        flow::match_blocks(fields[0].image, fields[2].image, layout, bias_px, settings, vectors);
        benchmark::DoNotOptimize(vectors.data());
    }
    state.counters["vectors"] = static_cast<double>(layout.size());
}

/// Best match over a window wider than the kernel's: adjacent tiles of 16x16 offsets. Tiles that would leave
/// the image are clipped or left out, as in match_blocks().
flow::BlockMatch best_of_tiles(const flow::KernelEntry& kernel, const ImageView& from, const ImageView& to,
                               const Eigen::Vector2i& corner, int tiles) {
    flow::BlockMatch best;
    for (int row = 0; row < tiles; ++row) {
        for (int column = 0; column < tiles; ++column) {
            const Eigen::Vector2i bias_px(flow::search_px * column - flow::search_px * (tiles - 1) / 2,
                                          flow::search_px * row - flow::search_px * (tiles - 1) / 2);
            const flow::SearchRange range = flow::clipped_range(corner, bias_px, to);
            if (range.empty()) continue;
            const Eigen::Vector2i at = corner + bias_px;
            const flow::BlockMatch match =
                kernel.match(from.row(corner.y()) + corner.x(), from.stride_bytes,
                             to.data + at.y() * to.stride_bytes + at.x(), to.stride_bytes, range);
            if (match.minimum < best.minimum) best = match;
        }
    }
    return best;
}

void time_window(benchmark::State& state, int tiles) {
    const auto& fields = fields_of(pal);
    const flow::BlockLayout layout = layout_of(fields[0], flow::FlowParams().blocks);
    const flow::KernelEntry& kernel = flow::select_kernel();
    while (state.KeepRunning()) {
        for (const Eigen::Vector2i& corner : layout.corner_px)
            benchmark::DoNotOptimize(best_of_tiles(kernel, fields[0].image, fields[2].image, corner, tiles));
    }
    state.counters["vectors"] = static_cast<double>(layout.size());
    state.counters["offsets"] = tiles * tiles * static_cast<double>(flow::search_offsets);
}

void time_step(benchmark::State& state, Size size, int threads) {
    SteadyChain chain(fields_of(size), flow::select_kernel(), threads);
    const auto see = [](const pipeline::Step& step) { benchmark::DoNotOptimize(&step); };
    chain.drive(see);
    while (state.KeepRunning()) state.SetIterationTime(chain.drive(see));
    state.counters["fields"] = static_cast<double>(chain.timed_fields());
    state.counters["ok_percent"] = 100.0 * chain.ok_share();
}

std::string text(const Size& size) {
    return std::to_string(size.width_px) + 'x' + std::to_string(size.height_px);
}

}  // namespace

void register_growth() {
    using benchmark::RegisterBenchmark;
    const int usual = flow::FlowParams().blocks;
    for (const int threads : {1, 2}) {
        const std::string suffix = "/threads-" + std::to_string(threads);
        for (const int blocks : {35, 100, 350, 1000, 2000})
            RegisterBenchmark(("growth/vectors/" + std::to_string(blocks) + suffix).c_str(), time_match, pal,
                              blocks, threads)
                ->UseRealTime();
        for (const Size size : {Size{384, 144}, pal, Size{1536, 576}, Size{3840, 2160}}) {
            RegisterBenchmark(("growth/image/" + text(size) + suffix).c_str(), time_match, size, usual,
                              threads)
                ->UseRealTime();
            RegisterBenchmark(("growth/step/" + text(size) + suffix).c_str(), time_step, size, threads)
                ->UseManualTime();
        }
    }
    for (const int tiles : {1, 2, 4})
        RegisterBenchmark(("growth/window/" + std::to_string(tiles * flow::search_px / 2)).c_str(),
                          time_window, tiles);
}

}  // namespace flownav::bench
