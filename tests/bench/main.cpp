// Measures speed and the time of each stage. Run: build/release/tests/bench/flownav-bench
#include <benchmark/benchmark.h>

#include <exception>
#include <iostream>
#include <opencv2/core/utility.hpp>

#include "benchmarks.h"

namespace {

int run(int argc, char** argv) {
    using namespace flownav::bench;  // NOLINT(google-build-using-namespace)
    cv::setNumThreads(1);
    register_kernels();
    register_flow_comparison();
    register_steps();
    register_growth();
    register_replays();
    benchmark::AddCustomContext("compiler", __VERSION__);
    benchmark::AddCustomContext("opencv", cv::getVersionString());
    benchmark::AddCustomContext("kernel", flownav::flow::select_kernel().name);
    benchmark::AddCustomContext("kernels", kernel_names(true));
    benchmark::AddCustomContext("kernels_unsupported", kernel_names(false));
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
