#include <gtest/gtest.h>

#include <cmath>

#include "drives.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

using pipeline::Step;

constexpr double image_s = 0.04;

/// A scene whose robot drives with the motion of `motion_of_image(i)` = (m/s, deg/s) from image i - 1 to i.
template <class MotionOfImage>
testing::Scene drive_with(int images, MotionOfImage motion_of_image) {
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = images;
    testing::Scene scene = testing::drive(options);
    for (int i = 1; i < images; ++i) {
        const auto [v_mps, omega_degps] = motion_of_image(i);
        const auto k = static_cast<std::size_t>(i);
        scene.poses[k] =
            compose(scene.poses[k - 1], along_arc(omega_degps * degree_rad * image_s, v_mps * image_s));
    }
    return scene;
}

std::pair<double, double> steady(int) {
    return {0.4, 5.0};
}

void expect_right(const Step& step, double v_mps, double omega_degps) {
    EXPECT_EQ(step.status, FieldStatus::Ok);
    EXPECT_NEAR(deg(step.omega_radps), omega_degps, 0.5);
    EXPECT_NEAR(step.v_mps, v_mps, 0.05);
}

TEST(LosingAndFinding, AJumpOfTheTurnRateIsRightInTheFirstImage) {
    for (const double after_degps : {-60.0, 40.0}) {
        const auto scene =
            drive_with(8, [&](int i) { return i < 7 ? steady(i) : std::pair(0.4, after_degps); });
        expect_right(testing::run(render_fields(scene)).back(), 0.4, after_degps);
    }
}

TEST(LosingAndFinding, AJumpOfTheSpeedIsRightInTheFirstImageOfItsCycle) {
    // Images 1 to 5 are one cycle.
    const auto scene = drive_with(7, [](int i) { return std::pair(i < 6 ? 0.4 : 1.2, 0.0); });
    expect_right(testing::run(render_fields(scene)).back(), 1.2, 0.0);
}

TEST(LosingAndFinding, ASpeedTooFastForTheWindowsIsFoundThoughTheTurnIsKnown) {
    // A wide lens near the floor: the far floor shows the turn, the near floor moves by 25 px.
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 4;
    options.v_mps = 1.6;
    options.camera.fx_px = options.camera.fy_px = 320.0;
    options.camera.mount.height_m = 0.5;
    options.camera.mount.pitch_rad = 18 * degree_rad;
    const auto steps = testing::run(render_fields(testing::drive(options)));
    for (std::size_t i = 1; i < steps.size(); ++i) {
        expect_right(steps[i], 1.6, 0.0);
        EXPECT_TRUE(steps[i].motion.forward_measured) << i;
    }
}

TEST(LosingAndFinding, AColdStartIntoAFastTurnIsRightAtOnce) {
    const auto scene = drive_with(2, [](int) { return std::pair(0.8, 100.0); });
    expect_right(testing::run(render_fields(scene)).back(), 0.8, 100.0);
}

TEST(LosingAndFinding, FlowFarBeyondTheSlidingWindowsIsFoundOnTheQuarterImages) {
    const auto scene = drive_with(2, [](int) { return std::pair(0.4, 240.0); });  // 100 px
    const Step step = testing::run(render_fields(scene)).back();
    EXPECT_EQ(step.status, FieldStatus::Ok);
    EXPECT_NEAR(deg(step.omega_radps), 240.0, 1.0);
}

TEST(LosingAndFinding, DroppedFieldsAreBridged) {
    std::vector<Field> fields = render_fields(drive_with(12, steady));
    fields.erase(fields.begin() + 8, fields.begin() + 10);
    const auto steps = testing::run(fields);
    expect_right(steps[8], 0.4, 5.0);
    expect_right(steps[9], 0.4, 5.0);
}

TEST(LosingAndFinding, AfterAGapOfSecondsTheSecondFieldIsRight) {
    std::vector<Field> fields = render_fields(drive_with(10, steady));
    for (std::size_t i = 7; i < fields.size(); ++i) fields[i] = testing::delayed(fields[i], 3.0);
    const auto steps = testing::run(fields);
    EXPECT_EQ(steps[7].status, FieldStatus::Waiting);
    EXPECT_TRUE(steps[7].restarted);
    expect_right(steps[8], 0.4, 5.0);
    expect_right(steps[9], 0.4, 5.0);
}

TEST(LosingAndFinding, ACoveredLensIsABadFieldAndTheNextCycleIsRight) {
    std::vector<Field> fields = render_fields(drive_with(24, steady));
    for (std::size_t i = 7; i < 15; ++i)
        fields[i] = testing::delayed(testing::grey_field(fields[i], 3, 0.0), 0.0);
    const auto steps = testing::run(fields);
    for (std::size_t i = 7; i < 15; ++i) EXPECT_EQ(steps[i].status, FieldStatus::BadField);
    for (std::size_t i = 20; i < 24; ++i) expect_right(steps[i], 0.4, 5.0);
}

TEST(LosingAndFinding, ATurnThatBeginsWithinACycleIsMeasuredAsWell) {
    const auto scene =
        drive_with(21, [](int i) { return std::pair(0.4, std::clamp(6.0 * (i - 8), 0.0, 30.0)); });
    const auto steps = testing::run(render_fields(scene));
    for (int i = 5; i < 21; ++i) {
        const double truth_degps = std::clamp(6.0 * (i - 8), 0.0, 30.0);
        EXPECT_NEAR(deg(steps[static_cast<std::size_t>(i)].omega_radps), truth_degps, 0.12) << i;
    }
}

TEST(LosingAndFinding, AStampThatIsWrongMakesNoTravel) {
    const auto scene = drive_with(16, [](int) { return std::pair(0.4, 0.0); });
    const double way_m = scene.poses.back().x_m;
    for (std::size_t wrong = 3; wrong < 14; ++wrong) {
        auto fields = render_fields(scene);
        fields[wrong].timestamp_s += 0.039;
        const auto steps = testing::run(fields, testing::cycles_of(2));
        EXPECT_NEAR(steps.back().T_start_robot.x_m, way_m, 0.03 * way_m) << wrong;
    }
}

}  // namespace
}  // namespace flownav
