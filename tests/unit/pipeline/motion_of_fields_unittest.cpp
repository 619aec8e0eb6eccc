#include <gtest/gtest.h>

#include <cmath>

#include "drives.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

using pipeline::Step;
using testing::cycles_of;
using testing::DriveOptions;

struct Errors {
    double omega_degps = 0.0;  ///< root mean square over the fields
    double v_percent = 0.0;    ///< mean over the cycles that measured it
    int cycles = 0;
};

/// Errors of the steps after the first cycle for a drive of constant speed and turn rate.
Errors errors_of(const DriveOptions& truth, const std::vector<Step>& steps, std::size_t settled) {
    Errors errors;
    double squares = 0.0, fields = 0.0;
    for (std::size_t i = settled; i < steps.size(); ++i) {
        EXPECT_EQ(steps[i].status, FieldStatus::Ok);
        squares += std::pow(deg(steps[i].omega_radps) - truth.omega_degps, 2);
        fields += 1;
        if (!steps[i].v_measured) continue;
        errors.v_percent += 100.0 * (steps[i].v_mps / truth.v_mps - 1.0);
        ++errors.cycles;
    }
    errors.omega_degps = std::sqrt(squares / fields);
    errors.v_percent /= std::max(1, errors.cycles);
    return errors;
}

Errors errors_of(const DriveOptions& options, int cycle_images) {
    return errors_of(options, testing::run(render_fields(testing::drive(options)), cycles_of(cycle_images)),
                     static_cast<std::size_t>(cycle_images) + 1);
}

TEST(MotionOfFields, StraightDriveHasItsSpeedAndNoTurn) {
    DriveOptions options;
    options.images = 13;
    const Errors errors = errors_of(options, 4);
    EXPECT_EQ(errors.cycles, 2);
    EXPECT_LT(errors.omega_degps, 0.15);
    EXPECT_LT(std::abs(errors.v_percent), 0.6);
}

TEST(MotionOfFields, TurnToTheLeftIsPositive) {
    DriveOptions options;
    options.images = 9;
    options.omega_degps = 10.0;
    EXPECT_LT(errors_of(options, 4).omega_degps, 0.2);
}

TEST(MotionOfFields, TurnToTheRightIsNegative) {
    DriveOptions options;
    options.images = 9;
    options.omega_degps = -10.0;
    EXPECT_LT(errors_of(options, 4).omega_degps, 0.2);
}

TEST(MotionOfFields, BackwardsIsNegative) {
    DriveOptions options;
    options.images = 9;
    options.v_mps = -0.3;
    EXPECT_LT(std::abs(errors_of(options, 4).v_percent), 0.6);
}

TEST(MotionOfFields, TurnOf30DegreesASecondIsFoundInTheFirstPair) {
    for (const double omega_degps : {30.0, -30.0}) {
        DriveOptions options;
        options.images = 2;
        options.omega_degps = omega_degps;
        const Step step = testing::run(render_fields(testing::drive(options)), cycles_of(4)).back();
        EXPECT_EQ(step.status, FieldStatus::Ok);
        EXPECT_NEAR(deg(step.omega_radps), omega_degps, 0.5);
        EXPECT_NEAR(step.v_mps, 0.4, 0.02);
    }
}

TEST(MotionOfFields, FieldsOfAlternatingParityNeedNoSpecialCase) {
    DriveOptions options;
    options.images = 10;
    options.omega_degps = 5.0;
    options.interlaced = true;
    const Errors errors = errors_of(options, 3);  // odd: the parity of the references alternates
    EXPECT_EQ(errors.cycles, 2);
    EXPECT_LT(errors.omega_degps, 0.3);
    EXPECT_LT(std::abs(errors.v_percent), 1.5);
}

TEST(MotionOfFields, OdometryEndsWhereTheRobotDoes) {
    DriveOptions options;
    options.images = 13;
    options.omega_degps = 15.0;
    const testing::Scene scene = testing::drive(options);
    const Pose2 end = testing::run(render_fields(scene), cycles_of(4)).back().T_start_robot;
    const Pose2 truth = compose(inverse(scene.poses.front()), scene.poses.back());
    EXPECT_NEAR(end.x_m, truth.x_m, 0.004);
    EXPECT_NEAR(end.y_m, truth.y_m, 0.002);
    EXPECT_NEAR(deg(end.yaw_rad), deg(truth.yaw_rad), 0.1);
}

TEST(MotionOfFields, OverAFloorWithoutTextureNothingIsMeasured) {
    DriveOptions options;
    options.floor = sim::Surface::Plain;
    for (const Step& step : testing::run(render_fields(testing::drive(options)), cycles_of(2))) {
        EXPECT_NE(step.status, FieldStatus::Ok);
        EXPECT_FALSE(step.v_measured);
        EXPECT_TRUE(step.obstacles.empty());
        for (const Beam& beam : step.scan.beams) EXPECT_EQ(beam.kind, BeamKind::Unknown);
    }
}

}  // namespace
}  // namespace flownav
