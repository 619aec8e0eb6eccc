#include "search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"
#include "flownav/sim/surface_texture.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/render.h"

namespace flownav::pipeline {
namespace {

using sim::View;

/// How the robot moves from the reference to the newest field; pitch raises the view.
struct Motion {
    double omega_rad = 0.0;
    double pitch_rad = 0.0;
    double forward_m = 0.0;
};

ReferenceImage held(const sim::World& world, const View& view, const CameraModel& nominal) {
    auto image = std::make_shared<testing::GreyImage>(testing::render(world, view));
    return {{view.time_s, image->view(), nominal, image}, RayMapper(nominal)};
}

/// Two fields of an empty floor, rendered before and after the motion.
class Fields {
  public:
    Fields(const CameraModel& camera, const Motion& motion, sim::Surface floor = sim::Surface::Carpet)
        : matcher_(flow::BlockMatcher(params_.flow, 1)) {
        sim::World world;
        world.floor = {floor, sim::usual_grey(floor), 5};
        View before{camera, {}, 0.0};
        // The chord points along half the turn.
        View after{camera,
                   {motion.forward_m * std::cos(motion.omega_rad / 2),
                    motion.forward_m * std::sin(motion.omega_rad / 2), motion.omega_rad},
                   0.04};
        after.camera.mount.pitch_rad -= motion.pitch_rad;
        reference_ = held(world, before, camera);
        newest_ = held(world, after, camera);
        layout_ = flow::every_nth(flow::place_blocks(reference_.mapper, params_.flow), 3);
    }

    motion::MotionPrediction motion(const motion::MotionPrediction& prediction = {}) {
        return search_motion(reference_, newest_, layout_, prediction, {params_, matcher_}, last_trial_);
    }
    motion::MotionPrediction travel(const motion::MotionPrediction& known) {
        return search_travel(reference_, newest_, layout_, known, {params_, matcher_}, last_trial_);
    }
    /// The motion found without a search, from the prediction alone.
    motion::MotionEstimate without_search(const motion::MotionPrediction& prediction = {}) {
        measure(reference_, newest_, layout_, prediction, {params_, matcher_}, last_trial_);
        return last_trial_.estimate;
    }

  private:
    Params params_;
    flow::Matcher matcher_;
    ReferenceImage reference_, newest_;
    flow::BlockLayout layout_;
    Measurement last_trial_;
};

/// A wide lens near the floor: the far floor shows the turn, and the near floor moves fast.
CameraModel low_camera() {
    CameraModel camera = testing::standard_camera();
    camera.fx_px = camera.fy_px = 320.0;
    camera.mount.height_m = 0.5;
    camera.mount.pitch_rad = 18.0 * degree_rad;
    return camera;
}

void expect_found(const motion::MotionPrediction& found, const Motion& truth, double tolerance_deg = 0.05) {
    EXPECT_NEAR(found.omega_rad, truth.omega_rad, tolerance_deg * degree_rad);
    EXPECT_NEAR(found.pitch_rad, truth.pitch_rad, tolerance_deg * degree_rad);
    EXPECT_NEAR(found.forward_m, truth.forward_m, 0.002 + 0.02 * std::abs(truth.forward_m));
}

TEST(SearchMotion, FindsATurnBeyondTheWindowsToEitherSide) {
    for (const double side : {1.0, -1.0}) {
        const Motion truth{4.0 * degree_rad * side, 0.0, 0.03};  // 43 px
        Fields fields(testing::standard_camera(), truth);
        EXPECT_GT(std::abs(fields.without_search().motion.omega_rad - truth.omega_rad), 1.0 * degree_rad);
        expect_found(fields.motion(), truth);
    }
}

TEST(SearchMotion, FindsATurnFarBeyondTheWindowsOnTheQuarterImages) {
    for (const double side : {1.0, -1.0}) {
        const Motion truth{9.6 * degree_rad * side, 0.0, 0.016};  // 104 px
        expect_found(Fields(testing::standard_camera(), truth).motion(), truth);
    }
}

TEST(SearchMotion, FindsAPitchUpAndDown) {
    for (const double direction : {1.0, -1.0}) {
        const Motion truth{0.0, 1.2 * degree_rad * direction, 0.016};  // 13 px
        Fields fields(testing::standard_camera(), truth);
        EXPECT_GT(std::abs(fields.without_search().motion.pitch_rad - truth.pitch_rad), 0.3 * degree_rad);
        expect_found(fields.motion(), truth);
    }
}

TEST(SearchMotion, FindsAPitchAboutATurnThatOnlyThePredictionKnows) {
    for (const double direction : {1.0, -1.0}) {
        const Motion truth{21.0 * degree_rad, 1.2 * degree_rad * direction,
                           0.016};  // 204 px, beyond all windows
        motion::MotionPrediction prediction;
        prediction.omega_rad = truth.omega_rad;
        Fields fields(testing::standard_camera(), truth);
        EXPECT_GT(std::abs(fields.motion().omega_rad - truth.omega_rad), 1.0 * degree_rad);
        // Large turns about two axes do not commute; the estimate adds them, hence the tolerance.
        expect_found(fields.motion(prediction), truth, 0.1);
    }
}

TEST(SearchMotion, FindsFastTravelForwardAndBackward) {
    for (const double forward_m : {0.1, 0.2, -0.05}) {  // 41 px, 82 px and 21 px at the lower border
        const Motion truth{0.0, 0.0, forward_m};
        Fields fields(testing::standard_camera(), truth);
        EXPECT_GT(std::abs(fields.without_search().motion.forward_m - forward_m), 0.02);
        expect_found(fields.motion(), truth);
    }
}

TEST(SearchMotion, FindsATurnWithFastTravel) {
    for (const double side : {1.0, -1.0}) {
        const Motion truth{3.0 * degree_rad * side, 0.0, 0.08};
        expect_found(Fields(testing::standard_camera(), truth).motion(), truth);
    }
}

TEST(SearchMotion, AWrongPredictionDoesNotDisturbIt) {
    motion::MotionPrediction wrong;
    wrong.omega_rad = 5.0 * degree_rad;
    wrong.forward_m = 0.2;
    const Motion truth{-4.0 * degree_rad, 0.0, 0.03};
    expect_found(Fields(testing::standard_camera(), truth).motion(wrong), truth);
}

TEST(SearchTravel, FindsTravelBeyondTheWindowsForwardAndBackward) {
    for (const double forward_m : {0.04, 0.075, -0.025}) {  // 27 px, 50 px and 17 px at the lower border
        for (const double omega_rad : {0.0, 1.0 * degree_rad, -1.0 * degree_rad}) {
            Fields fields(low_camera(), {omega_rad, 0.0, forward_m});
            motion::MotionPrediction known;
            known.omega_rad = omega_rad;
            EXPECT_FALSE(std::abs(fields.without_search(known).motion.forward_m - forward_m) < 0.005);
            const motion::MotionPrediction found = fields.travel(known);
            EXPECT_NEAR(found.forward_m, forward_m, 0.02 * std::abs(forward_m)) << omega_rad;
            EXPECT_EQ(found.omega_rad, omega_rad) << "the rotation is known";
            EXPECT_EQ(found.pitch_rad, 0.0);
        }
    }
}

TEST(SearchTravel, OverAFloorWithoutTextureItIsWhatIsKnown) {
    for (const double forward_m : {0.05, -0.05}) {
        motion::MotionPrediction known;
        known.omega_rad = 0.01;
        known.forward_m = forward_m;
        const motion::MotionPrediction found =
            Fields(low_camera(), {0.01, 0.0, 0.064}, sim::Surface::Plain).travel(known);
        EXPECT_EQ(found.forward_m, forward_m);
        EXPECT_EQ(found.omega_rad, 0.01);
    }
}

}  // namespace
}  // namespace flownav::pipeline
