#include <benchmark/benchmark.h>

#include <cmath>

#include "flownav/nav/make_navigator.h"

namespace flownav::nav {
namespace {

using mrpt::maps::COccupancyGridMap2D;

/// A map of 10 m x 10 m with posts everywhere except around the robot.
COccupancyGridMap2D posts(double cell_m) {
    COccupancyGridMap2D map(-5.0F, 5.0F, -5.0F, 5.0F, static_cast<float>(cell_m));
    map.fill(0.8F);
    for (float y = -4.5F; y < 4.6F; y += 0.9F)
        for (float x = -4.5F; x < 4.6F; x += 1.1F)
            if (std::hypot(x, y) > 0.7F) map.setPos(x, y, 0.1F);
    return map;
}

/// Cell size in metres; the argument is in centimetres.
double cell_m(const benchmark::State& state) {
    return static_cast<double>(state.range(0)) / 100.0;
}

void lane_tables(benchmark::State& state) {
    LaneLayout layout;
    layout.resolution_m = cell_m(state);
    for (auto _ : state) benchmark::DoNotOptimize(make_lane_tables(RobotModel(), layout));
}
BENCHMARK(lane_tables)->Arg(5)->Arg(10)->Unit(benchmark::kMillisecond);

void choose_lane(benchmark::State& state) {
    LaneLayout layout;
    layout.resolution_m = cell_m(state);
    const LaneTables tables = make_lane_tables(RobotModel(), layout);
    const COccupancyGridMap2D map = posts(layout.resolution_m);
    for (auto _ : state)
        benchmark::DoNotOptimize(nav::choose_lane(tables, map, {3.0, 0.5}, {0.4, 0.0}, LaneParams()));
}
BENCHMARK(choose_lane)->Arg(5)->Arg(10)->Unit(benchmark::kMicrosecond);

void decide(benchmark::State& state, const char* name) {
    NavigatorOptions options;
    options.resolution_m = cell_m(state);
    const auto navigator = make_navigator(name, options);
    const COccupancyGridMap2D map = posts(options.resolution_m);
    double time_s = 0.0;
    for (auto _ : state) {
        time_s += 0.2;
        benchmark::DoNotOptimize(navigator->decide({time_s, {}, {0.4, 0.0}, &map, true}, {3.0, 0.5}));
    }
}
BENCHMARK_CAPTURE(decide, lanes, "lanes")->Arg(5)->Arg(10)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(decide, reactive, "reactive")->Arg(5)->Arg(10)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace flownav::nav
