// How the time grows with the vectors, the image and the search window, on one thread and two.
#include <benchmark/benchmark.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "benchmarks.h"
#include "flownav/flow/match_blocks.h"
#include "sample.h"
#include "steady_chain.h"

namespace flownav::bench {
namespace {

/// A field in another size: the same view with larger or smaller pixels.
Field resized(const Field& field, int width_px, int height_px) {
    const cv::Mat from(field.image.height_px, field.image.width_px, CV_8UC1,
                       const_cast<std::uint8_t*>(field.image.data),  // nothing writes to it
                       static_cast<std::size_t>(field.image.stride_bytes));
    const auto to = std::make_shared<cv::Mat>();
    cv::resize(from, *to, {width_px, height_px}, 0, 0, cv::INTER_CUBIC);
    Field result = field;
    result.image = {to->data, width_px, height_px, static_cast<std::ptrdiff_t>(to->step)};
    result.owner = to;
    CameraModel& camera = result.camera;
    const double across = static_cast<double>(width_px) / camera.width_px;
    const double down = static_cast<double>(height_px) / camera.height_px;
    camera.width_px = width_px;
    camera.height_px = height_px;
    camera.fx_px *= across;
    camera.fy_px *= down;
    camera.cx_px = (camera.cx_px + 0.5) * across - 0.5;
    camera.cy_px = (camera.cy_px + 0.5) * down - 0.5;
    return result;
}

struct Size {
    int width_px, height_px;
};
constexpr Size pal{768, 288};

std::vector<Field> fields_of(const Size& size, std::size_t count) {
    std::vector<Field> fields;
    for (const Field& field : sample_fields())
        if (fields.size() < count) fields.push_back(resized(field, size.width_px, size.height_px));
    return fields;
}

BlockLayout layout_of(const Field& field, int blocks) {
    FlowParams params;
    params.blocks = blocks;
    return place_blocks(RayMapper(field.camera), params);
}

void time_match(benchmark::State& state, Size size, int blocks, int threads) {
    const auto fields = fields_of(size, 3);
    const BlockLayout layout = layout_of(fields[0], blocks);
    const std::vector<Eigen::Vector2i> bias_px(layout.size(), Eigen::Vector2i::Zero());
    MatchSettings settings;
    settings.threads = threads;
    std::vector<FlowVector> vectors;
    while (state.KeepRunning()) {
        match_blocks(fields[0].image, fields[2].image, layout, bias_px, settings, vectors);
        benchmark::DoNotOptimize(vectors.data());
    }
    state.counters["vectors"] = static_cast<double>(layout.size());
}

/// A window wider than the kernel's: tiles of 16x16 offsets side by side, the smallest minimum of all. Tiles
/// that would leave the image are clipped or left out, as match_blocks() does.
BlockMatch best_of_tiles(const KernelEntry& kernel, const ImageView& from, const ImageView& to,
                         const Eigen::Vector2i& corner, int tiles) {
    BlockMatch best;
    for (int row = 0; row < tiles; ++row) {
        for (int column = 0; column < tiles; ++column) {
            const Eigen::Vector2i bias_px(search_px * column - search_px * (tiles - 1) / 2,
                                          search_px * row - search_px * (tiles - 1) / 2);
            const SearchRange range = clipped_range(corner, bias_px, to);
            if (range.empty()) continue;
            const Eigen::Vector2i at = corner + bias_px;
            const BlockMatch match =
                kernel.match(from.row(corner.y()) + corner.x(), from.stride_bytes,
                             to.data + at.y() * to.stride_bytes + at.x(), to.stride_bytes, range);
            if (match.minimum < best.minimum) best = match;
        }
    }
    return best;
}

void time_window(benchmark::State& state, int tiles) {
    const auto fields = fields_of(pal, 3);
    const BlockLayout layout = layout_of(fields[0], FlowParams().blocks);
    const KernelEntry& kernel = select_kernel();
    while (state.KeepRunning()) {
        for (const Eigen::Vector2i& corner : layout.corner_px)
            benchmark::DoNotOptimize(best_of_tiles(kernel, fields[0].image, fields[2].image, corner, tiles));
    }
    state.counters["vectors"] = static_cast<double>(layout.size());
    state.counters["offsets"] = tiles * tiles * static_cast<double>(search_offsets);
}

void time_step(benchmark::State& state, Size size, int threads) {
    SteadyChain chain(fields_of(size, 24), select_kernel(), threads);
    const auto see = [](const pipeline::Step& step) { benchmark::DoNotOptimize(&step); };
    chain.drive(see);
    while (state.KeepRunning()) chain.drive(see);
    state.counters["fields"] = 24;
}

std::string text(const Size& size) {
    return std::to_string(size.width_px) + 'x' + std::to_string(size.height_px);
}

}  // namespace

void register_growth() {
    using benchmark::RegisterBenchmark;
    const int usual = FlowParams().blocks;
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
                ->UseRealTime();
        }
    }
    for (const int tiles : {1, 2, 4})
        RegisterBenchmark(("growth/window/" + std::to_string(tiles * search_px / 2)).c_str(), time_window,
                          tiles);
}

}  // namespace flownav::bench
