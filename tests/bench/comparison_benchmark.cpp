// Compares flownav with other methods on the same blocks: time, and error against known flow.
#include <benchmark/benchmark.h>

#include <map>

#include "benchmarks.h"
#include "fidelity/statistics.h"
#include "flownav/flow/kernel.h"
#include "known_flow.h"
#include "mestimate.h"
#include "methods.h"

namespace flownav::bench {
namespace {

using Eigen::Vector2d;

/// End-point errors of a method over a case.
class Errors {
  public:
    void add(const Vector2d& measured_px, const Vector2d& true_px, bool kept) {
        const double error_px = (measured_px - true_px).norm();
        all_px_.push_back(error_px);
        mean_.add(error_px);
        over_1_.add(error_px > 1.0);
        over_3_.add(error_px > 3.0);
        kept_.add(kept);
        if (kept) kept_over_1_.add(error_px > 1.0);
        if (kept) kept_mean_.add(error_px);
        if (error_px <= 1.0) inlier_mean_.add(error_px);
    }

    void report(benchmark::State& state) const {
        state.counters["mean_px"] = mean_.mean();
        state.counters["median_px"] = fidelity::median(all_px_);
        state.counters["inlier_mean_px"] = inlier_mean_.mean();
        state.counters["over_1_percent"] = over_1_.percent();
        state.counters["over_3_percent"] = over_3_.percent();
        state.counters["kept_percent"] = kept_.percent();
        state.counters["kept_mean_px"] = kept_mean_.mean();
        state.counters["kept_over_1_percent"] = kept_over_1_.percent();
        state.counters["judged"] = static_cast<double>(all_px_.size());
    }

  private:
    std::vector<double> all_px_;
    fidelity::Moments mean_, kept_mean_, inlier_mean_;
    fidelity::Share over_1_, over_3_, kept_, kept_over_1_;
};

bool in_window(const Vector2d& flow_px) {
    return flow_px.minCoeff() >= flow::search_min - 0.5 && flow_px.maxCoeff() <= flow::search_max + 0.5;
}

/// Percentage of the blocks with known flow whose flow lies outside the search window.
double beyond_window_percent(const FlowCase& flow) {
    fidelity::Share beyond;
    for (const FlowPair& pair : flow.pairs)
        for (const Vector2d& at : pair.layout.centre_px)
            if (const auto truth = pair.truth(at)) beyond.add(!in_window(*truth));
    return beyond.percent();
}

void time_method(benchmark::State& state, const FlowCase& flow, const FlowMethod& method) {
    const MeasureFlow measure = method.make();
    MeasuredFlow measured;
    Errors errors;
    std::size_t vectors = 0;
    for (const FlowPair& pair : flow.pairs) {
        measure(pair, measured);
        vectors += measured.flow_px.size();
        for (std::size_t i = 0; i < measured.flow_px.size(); ++i)
            if (const auto truth = pair.truth(pair.layout.centre_px[i]))
                errors.add(measured.flow_px[i], *truth, measured.kept[i] != 0);
    }
    while (state.KeepRunning()) {
        for (const FlowPair& pair : flow.pairs) measure(pair, measured);
        benchmark::DoNotOptimize(measured.flow_px.data());
    }
    errors.report(state);
    state.counters["vectors"] = static_cast<double>(vectors);
    state.counters["beyond_window_percent"] = beyond_window_percent(flow);
}

/// The images of a sequence forward and backward, which avoids a jump.
std::vector<const testing::GreyImage*> there_and_back(const FlowCase& flow) {
    std::vector<const testing::GreyImage*> images;
    for (const FlowPair& pair : flow.pairs) images.push_back(&pair.reference);
    for (auto pair = flow.pairs.rbegin(); pair != flow.pairs.rend(); ++pair) images.push_back(&pair->newer);
    return images;
}

/// FFmpeg measures all blocks of an image instead of 350, in both directions; `vectors` has their number.
void time_mestimate(benchmark::State& state, const FlowCase& flow, const std::string& method) {
    const testing::GreyImage& first = flow.pairs.front().reference;
    Mestimate estimate(first.width_px, first.height_px, method);
    estimate.push(first.view());
    Errors errors;
    for (const FlowPair& pair : flow.pairs) {
        estimate.push(pair.newer.view());
        for (const MestimateVector& vector : estimate.vectors())
            if (const auto truth = pair.truth(vector.at_px)) errors.add(vector.flow_px, *truth, true);
    }
    const auto images = there_and_back(flow);
    std::size_t vectors = 0;
    while (state.KeepRunning()) {
        vectors = 0;
        for (const testing::GreyImage* image : images) vectors += estimate.push(image->view());
    }
    errors.report(state);
    state.counters["vectors"] = static_cast<double>(vectors);
}

/// Creates a case at its first use.
const FlowCase& flow_case(const std::string& name) {
    static std::map<std::string, FlowCase> cases;
    if (name == "rendered") return rendered_case();
    const auto found = cases.find(name);
    return found != cases.end() ? found->second : cases.emplace(name, middlebury_case(name)).first->second;
}

}  // namespace

void register_flow_comparison() {
    std::vector<std::string> names = middlebury_names();
    names.insert(names.begin(), "rendered");
    for (const std::string& name : names) {
        for (const FlowMethod& method : all_methods())
            benchmark::RegisterBenchmark(
                ("flow/" + name + '/' + method.name).c_str(),
                [name, method](benchmark::State& state) { time_method(state, flow_case(name), method); });
    }
    for (const char* method : {"esa", "epzs"})
        benchmark::RegisterBenchmark(
            (std::string("flow/rendered/mestimate-") + method).c_str(),
            [method](benchmark::State& state) { time_mestimate(state, flow_case("rendered"), method); });
}

}  // namespace flownav::bench
