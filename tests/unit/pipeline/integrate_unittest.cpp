#include "integrate.h"

#include <gtest/gtest.h>

/// Rates to predict the next field from.
namespace flownav::pipeline {
namespace {

/// The rates after a motion of `forward_m` and `omega_rad` within `interval_s`, at 0.4 m/s and 0.1 rad/s
/// before.
Rates rates_after(double forward_m, double omega_rad, double interval_s) {
    AcceptedMotion accepted;
    accepted.status = FieldStatus::Ok;
    accepted.motion.forward_m = forward_m;
    accepted.motion.omega_rad = omega_rad;
    accepted.motion.forward_measured = accepted.motion.omega_measured = true;
    Rates before;
    before.known = before.v_known = true;
    before.v_mps = 0.4;
    before.omega_radps = 0.1;
    Odometry odometry;
    odometry.measured_s = 100.0;
    return integrate(accepted, odometry, before, 100.0 + interval_s, {interval_s, interval_s}, 1.0).rates;
}

TEST(Integrate, ASpeedThatNoRobotReachesIsNotPredictedFrom) {
    const Rates rates = rates_after(0.016, 0.004, 0.001);  // two images 1 ms apart: 16 m/s and 4 rad/s
    EXPECT_LT(rates.v_mps, 0.8);
    EXPECT_LT(rates.omega_radps, 0.8);
}

TEST(Integrate, AJumpOfTheSpeedThatARobotCanMakeIsPredictedFrom) {
    const Rates rates = rates_after(0.04 * 1.2, 0.04 * -2.0, 0.04);
    EXPECT_NEAR(rates.v_mps, 1.2, 1e-9);
    EXPECT_NEAR(rates.omega_radps, -2.0, 1e-9);
}

}  // namespace
}  // namespace flownav::pipeline
