// Times one whole step and its stages in the steady state, with the layout made and all memory allocated.
#include <benchmark/benchmark.h>

#include <chrono>

#include "benchmarks.h"
#include "flownav/flow/brightness.h"
#include "flownav/mapping/local_map.h"
#include "flownav/motion/estimate_motion.h"
#include "flownav/pipeline/pipeline.h"
#include "sample.h"
#include "steady_chain.h"

namespace flownav::bench {
namespace {

void time_steps(benchmark::State& state, const flow::KernelEntry& kernel, bool with_map) {
    SteadyChain chain(sample_fields(), kernel, 1);
    mapping::LocalMap map{mapping::MapParams()};
    const auto enter = [&](const pipeline::Step& step) {
        if (with_map && step.end_of_cycle && !step.obstacles.empty())
            map.insert({step.timestamp_s, step.T_start_robot, step.obstacles, step.ground});
    };
    chain.drive(enter);
    while (state.KeepRunning()) state.SetIterationTime(chain.drive(enter));
    state.counters["fields"] = static_cast<double>(chain.timed_fields());
    state.counters["match_us"] = 1e6 * chain.match_s();
}

/// Times the brightness compensation, which is part of matching.
void time_brightness(benchmark::State& state) {
    const auto& fields = sample_fields();
    const flow::BlockLayout layout = flow::place_blocks(RayMapper(fields[0].camera), flow::FlowParams());
    const std::vector<Eigen::Vector2i> bias_px(layout.size(), Eigen::Vector2i::Zero());
    flow::GreySums sums;
    while (state.KeepRunning()) {
        for (std::size_t i = 0; i + 2 < fields.size(); ++i)
            benchmark::DoNotOptimize(
                flow::compare_brightness(fields[i].image, fields[i + 2].image, layout, bias_px, sums));
    }
    state.counters["fields"] = static_cast<double>(fields.size() - 2);
}

/// Input of the ego-motion of one field.
struct MotionCase {
    std::vector<motion::MotionSample> samples;
    CameraModel camera;
    motion::MotionPrediction prediction;
};

std::vector<MotionCase> motion_cases() {
    std::vector<MotionCase> cases;
    pipeline::State state{pipeline::Params()};
    for (const Field& field : sample_fields()) {
        const pipeline::Step& step = pipeline::step(state, field);
        if (step.status != FieldStatus::Ok) continue;
        MotionCase one;
        one.camera = field.camera;
        for (const pipeline::BlockRecord& block : step.blocks)
            if (block.fresh) one.samples.push_back({block.ray, block.in_ground_window});
        one.prediction.omega_rad = step.motion.omega_rad;
        one.prediction.pitch_rad = step.motion.pitch_rad;
        one.prediction.forward_m = step.motion.forward_m;
        one.prediction.chord_rad = step.motion.chord_rad;
        cases.push_back(one);
    }
    return cases;
}

void time_ego_motion(benchmark::State& state) {
    const auto cases = motion_cases();
    motion::MotionScratch scratch;
    while (state.KeepRunning()) {
        for (const MotionCase& c : cases)
            benchmark::DoNotOptimize(
                motion::estimate_motion(c.samples, c.camera, c.prediction, motion::MotionParams(), scratch));
    }
    state.counters["fields"] = static_cast<double>(cases.size());
}

}  // namespace

void register_steps() {
    for_each_kernel([](const flow::KernelEntry& kernel) {
        const std::string name = std::string("step/") + kernel.name;
        benchmark::RegisterBenchmark(name.c_str(), time_steps, kernel, false)->UseManualTime();
        benchmark::RegisterBenchmark((name + "/map").c_str(), time_steps, kernel, true)->UseManualTime();
    });
    benchmark::RegisterBenchmark("stage/brightness", time_brightness);
    benchmark::RegisterBenchmark("stage/ego-motion", time_ego_motion);
}

}  // namespace flownav::bench
