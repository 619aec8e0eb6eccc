#include "pitch_online.h"

#include <gtest/gtest.h>

#include "exact_samples.h"
#include "flownav/math/units.h"
#include "flownav/pipeline/pipeline.h"
#include "flownav/testing/scene.h"

namespace flownav::pipeline {
namespace {

constexpr int images = 4;

/// Feeds one cycle of exact flow from a camera whose assumed pitch is `error_rad` too far down.
void learn_cycle(PitchOnline& pitch, double error_rad, double omega_degps) {
    const testing::Pair pair = testing::drive(testing::standard_camera(), 0.4, omega_degps, images);
    CameraModel assumed = pair.from.camera;
    assumed.mount.pitch_rad += error_rad + pitch.correction_rad();
    pitch.observe(testing::exact_samples(pair), assumed,
                  testing::estimate(pair, testing::exact_samples(pair)).motion, Geometry::MidPoint);
    pitch.learn(pair.truth);
}

TEST(PitchOnline, SettlesOnTheTruePitchWithinHundredthsOfADegree) {
    for (const double error_rad : {0.8 * degree_rad, -0.8 * degree_rad, 0.0}) {
        PitchOnline pitch;
        for (int cycle = 0; cycle < 40; ++cycle) learn_cycle(pitch, error_rad, cycle % 2 == 0 ? 10.0 : -5.0);
        EXPECT_NEAR(pitch.correction_rad(), -error_rad, 0.02 * degree_rad);
    }
}

TEST(PitchOnline, DoesNotJumpOnTheFirstCycle) {
    PitchOnline pitch;
    learn_cycle(pitch, 0.9 * degree_rad, 5.0);
    EXPECT_LT(pitch.correction_rad(), -0.1 * degree_rad);
    EXPECT_GT(pitch.correction_rad(), -0.5 * degree_rad);
}

TEST(PitchOnline, LearnsNothingFromAFloorThatCannotBeSeen) {
    PitchOnline pitch;
    const testing::Pair pair = testing::drive(testing::standard_camera(), 0.4, 5.0, images);
    std::vector<motion::MotionSample> few = testing::exact_samples(pair);
    few.resize(20);
    CameraModel assumed = pair.from.camera;
    assumed.mount.pitch_rad += 0.5 * degree_rad;
    pitch.observe(few, assumed, pair.truth, Geometry::MidPoint);
    pitch.learn(pair.truth);
    EXPECT_EQ(pitch.correction_rad(), 0.0);
}

/// Pitch correction in use at the last field of a rendered drive with a mount that is wrong.
struct Learnt {
    double correction_rad = 0.0;
    int restarts = 0;
};

Learnt drive(double pitch_error_deg, bool pitch_online) {
    testing::SceneOptions options;
    options.kind = testing::SceneKind::Turns;
    options.images = 80;
    options.camera = testing::standard_camera(320, 240);
    const testing::Scene scene = testing::make_scene(options);
    Params params;
    params.flow.blocks = 200;
    params.rate.cycle_images = 4;
    params.pitch_online = pitch_online;
    State state(params);
    Learnt learnt;
    for (int i = 0; i < scene.images(); ++i) {
        Field field = testing::make_field(scene, i);
        field.camera.mount.pitch_rad += pitch_error_deg * degree_rad;
        const Step& s = step(state, field);
        learnt.correction_rad = s.pitch_correction_rad;
        learnt.restarts += s.restarted;
    }
    return learnt;
}

TEST(PitchOnline, InThePipelineItIsOffUnlessAskedFor) {
    EXPECT_FALSE(Params{}.pitch_online);
    EXPECT_EQ(drive(1.5, false).correction_rad, 0.0);
}

TEST(PitchOnline, InThePipelineItIsReportedAndNeedsNoRestart) {
    const Learnt learnt = drive(1.5, true);
    EXPECT_LT(learnt.correction_rad, -0.7 * degree_rad);
    EXPECT_GT(learnt.correction_rad, -1.6 * degree_rad);
    EXPECT_EQ(learnt.restarts, 0);
}

}  // namespace
}  // namespace flownav::pipeline
