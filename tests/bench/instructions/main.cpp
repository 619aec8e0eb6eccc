// Program for callgrind: runs field after field through the matcher, then through the whole chain. Without
// valgrind the requests to it have no effect. Usage: flownav-bench-instructions RAWLOG KERNEL; status 77:
// unsupported kernel.
#include <valgrind/callgrind.h>

#include <algorithm>
#include <exception>
#include <iostream>

#include "flownav/flow/match_blocks.h"
#include "flownav/pipeline/pipeline.h"
#include "sample.h"

namespace flownav::bench {
namespace {

constexpr std::size_t settling_fields = 10;  // the first fields allocate memory and have no prediction
constexpr std::size_t counted_fields = 30;

/// Null when the kernel is not in the table or the processor does not support it.
const flow::KernelEntry* find_kernel(const std::string& name) {
    const auto& table = flow::kernel_table();
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const flow::KernelEntry& k) { return name == k.name; });
    return found != table.end() && found->supported() ? &*found : nullptr;
}

void match(const std::vector<Field>& fields, const flow::KernelEntry& kernel) {
    const Field& reference = fields[settling_fields];
    const flow::BlockLayout layout = flow::place_blocks(RayMapper(reference.camera), flow::FlowParams());
    const std::vector<Eigen::Vector2i> bias_px(layout.size(), Eigen::Vector2i::Zero());
    flow::MatchSettings settings;
    settings.kernel = &kernel;
    std::vector<FlowVector> vectors(layout.size());
    CALLGRIND_START_INSTRUMENTATION;
    for (std::size_t i = 1; i <= counted_fields; ++i)
        flow::match_blocks(reference.image, fields[settling_fields + i].image, layout, bias_px, settings,
                           vectors);
    CALLGRIND_STOP_INSTRUMENTATION;
    CALLGRIND_DUMP_STATS_AT("match");
}

void step(const std::vector<Field>& fields, const flow::KernelEntry& kernel) {
    const pipeline::Params params;
    pipeline::State state(params, flow::BlockMatcher(params.flow, 1, kernel));
    for (std::size_t i = 0; i < settling_fields; ++i) pipeline::step(state, fields[i]);
    CALLGRIND_START_INSTRUMENTATION;
    for (std::size_t i = 0; i < counted_fields; ++i) pipeline::step(state, fields[settling_fields + i]);
    CALLGRIND_STOP_INSTRUMENTATION;
    CALLGRIND_DUMP_STATS_AT("step");
}

int run(const std::string& rawlog, const std::string& kernel_name) {
    const flow::KernelEntry* kernel = find_kernel(kernel_name);
    if (kernel == nullptr) {
        std::cerr << "kernel " << kernel_name << ": not in the table, or not supported here\n";
        return 77;
    }
    const std::vector<Field> fields = read_fields(rawlog);
    if (fields.size() <= settling_fields + counted_fields) {
        std::cerr << rawlog << ": too short\n";
        return 1;
    }
    match(fields, *kernel);
    step(fields, *kernel);
    std::cout << counted_fields << '\n';
    return 0;
}

}  // namespace
}  // namespace flownav::bench

int main(int argc, char** argv) {
    try {
        if (argc == 3) return flownav::bench::run(argv[1], argv[2]);
        std::cerr << "usage: flownav-bench-instructions RAWLOG KERNEL\n";
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
    }
    return 1;
}
