#include "flownav/motion/agreement.h"

#include <gtest/gtest.h>

namespace flownav::motion {
namespace {

constexpr double cycle_s = 0.2;

Agreement new_agreement() {
    return Agreement({0.15, 0.05, 0.25});
}

/// Notes cycles of 0.08 m by the flow in which the other sensor tells `ratio` times as much.
void drive(Agreement& agreement, double& time_s, int cycles, double ratio) {
    for (int i = 0; i < cycles; ++i) {
        time_s += cycle_s;
        agreement.note({time_s, 0.08, 0.08 * ratio, 0.002});
    }
}

TEST(Agreement, IsUncheckedUntilEnoughMotionWasMeasured) {
    Agreement agreement = new_agreement();
    double time_s = 0.0;
    EXPECT_EQ(agreement.verdict(), SensorAgreement::Unchecked);
    drive(agreement, time_s, 1, 1.0);
    EXPECT_EQ(agreement.verdict(), SensorAgreement::Unchecked);
    drive(agreement, time_s, 2, 1.0);
    EXPECT_EQ(agreement.verdict(), SensorAgreement::Agrees);
    EXPECT_NEAR(agreement.ratio(), 1.0, 1e-12);
}

TEST(Agreement, AnErrorOfTenPercentIsNoContradiction) {
    Agreement agreement = new_agreement();
    double time_s = 0.0;
    drive(agreement, time_s, 40, 1.1);
    EXPECT_EQ(agreement.verdict(), SensorAgreement::Agrees);
    EXPECT_NEAR(agreement.ratio(), 1.1, 1e-12);
}

TEST(Agreement, AWrongSignScaleOrSlipIsAContradiction) {
    for (const double ratio : {-1.0, 2.0, 0.4, 0.0}) {
        Agreement agreement = new_agreement();
        double time_s = 0.0;
        drive(agreement, time_s, 15, ratio);
        EXPECT_EQ(agreement.verdict(), SensorAgreement::Contradicts) << ratio;
        EXPECT_NEAR(agreement.ratio(), ratio, 1e-12);
    }
}

TEST(Agreement, WheelsThatSpinWhileTheRobotStandsContradict) {
    Agreement agreement = new_agreement();
    for (int i = 1; i <= 15; ++i) agreement.note({i * cycle_s, 0.0, 0.08, 0.002});
    EXPECT_EQ(agreement.verdict(), SensorAgreement::Contradicts);
}

TEST(Agreement, NoiseOfAStandingRobotIsNoContradiction) {
    Agreement agreement = new_agreement();
    for (int i = 1; i <= 60; ++i) agreement.note({i * cycle_s, 0.002 * (i % 3 - 1), 0.0, 0.002});
    EXPECT_EQ(agreement.verdict(), SensorAgreement::Unchecked);
}

TEST(Agreement, AContradictionEndsSomeSecondsAfterItsCause) {
    Agreement agreement = new_agreement();
    double time_s = 0.0;
    drive(agreement, time_s, 20, 1.0);
    drive(agreement, time_s, 12, 2.5);
    ASSERT_EQ(agreement.verdict(), SensorAgreement::Contradicts);
    drive(agreement, time_s, 2, 1.0);
    EXPECT_EQ(agreement.verdict(), SensorAgreement::Contradicts);
    drive(agreement, time_s, 20, 1.0);
    EXPECT_EQ(agreement.verdict(), SensorAgreement::Agrees);
}

}  // namespace
}  // namespace flownav::motion
