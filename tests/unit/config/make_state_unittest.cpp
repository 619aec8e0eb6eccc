#include "flownav/config/make_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "flownav/flow/lk_matcher.h"
#include "flownav/testing/scene.h"

namespace flownav::config {
namespace {

Config with_matcher(const std::string& name) {
    Config config;
    set_config_value(config, "flow.matcher", name);
    return config;
}

struct Drive {
    testing::Scene scene;
    std::vector<Field> fields;
};

Drive turning_drive() {
    testing::SceneOptions options;
    options.kind = testing::SceneKind::SCurve;
    options.seed = 5;
    options.images = 10;
    Drive drive{testing::make_scene(options), {}};
    for (int i = 0; i < drive.scene.images(); ++i)
        drive.fields.push_back(testing::make_field(drive.scene, i));
    return drive;
}

struct Outcome {
    std::vector<FlowVector> vectors;  ///< vectors of the last field
    double worst_omega_radps = 0.0;   ///< largest error
    int ok = 0;                       ///< number of fields
};

Outcome drive_through(pipeline::State state, const Drive& drive) {
    Outcome outcome;
    for (std::size_t i = 0; i < drive.fields.size(); ++i) {
        const pipeline::Step& step = pipeline::step(state, drive.fields[i]);
        outcome.vectors.clear();
        for (const auto& block : step.blocks) outcome.vectors.push_back(block.vector);
        if (step.status != FieldStatus::Ok) continue;
        ++outcome.ok;
        const EgoMotion truth = testing::exact_motion(drive.scene.poses[i - 1], drive.scene.poses[i]);
        const double error_radps = step.omega_radps - truth.omega_rad * drive.scene.options.rate_hz;
        outcome.worst_omega_radps = std::max(outcome.worst_omega_radps, std::abs(error_radps));
    }
    return outcome;
}

bool same(const Outcome& a, const Outcome& b) {
    return std::equal(a.vectors.begin(), a.vectors.end(), b.vectors.begin(), b.vectors.end(),
                      [](const FlowVector& p, const FlowVector& q) {
                          return p.flow_px == q.flow_px && p.confidence == q.confidence;
                      });
}

TEST(MakeState, TheKeySelectsTheMatcherAndBothMeasureTheTurn) {
    const Drive drive = turning_drive();
    const Outcome sad = drive_through(make_state(with_matcher("sad")), drive);
    const Outcome lk = drive_through(make_state(with_matcher("lk")), drive);
    EXPECT_TRUE(same(sad, drive_through(pipeline::State(pipeline::Params{}), drive)));
    EXPECT_TRUE(same(lk, drive_through({pipeline::Params{}, flow::LkMatcher{}}, drive)));
    EXPECT_FALSE(same(sad, lk));
    for (const Outcome& outcome : {sad, lk}) {
        EXPECT_EQ(outcome.ok, drive.scene.images() - 1);
        EXPECT_LT(outcome.worst_omega_radps, 0.005);
    }
}

TEST(MakeState, APipelineOfAnUnknownMatcherIsRefused) {
    pipeline::Params params;
    params.flow.matcher = "ssd";
    EXPECT_THROW(pipeline::State{params}, std::invalid_argument);
    Config config;
    config.pipeline = params;
    EXPECT_THROW(make_state(config), std::invalid_argument);
}

}  // namespace
}  // namespace flownav::config
