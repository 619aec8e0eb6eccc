// Errors of the equations as printed for the finite displacements of a cycle of four images, with exact flow.
#include <gtest/gtest.h>

#include <cmath>

#include "exact_samples.h"
#include "flownav/math/units.h"
#include "flownav/testing/camera.h"

namespace flownav::motion {
namespace {

constexpr int cycle = 4;

struct Errors {
    double travel_percent = 0.0;
    double omega_degps = 0.0;
};

Errors errors_of(Geometry geometry, double omega_degps) {
    const testing::Pair pair = testing::drive(testing::standard_camera(), 0.4, omega_degps, cycle);
    MotionParams params;
    params.model = MotionModel::Yaw;
    const EgoMotion found = testing::estimate(pair, exact_samples(pair, geometry), params).motion;
    return {100.0 * (found.forward_m / pair.truth.forward_m - 1.0),
            (found.omega_rad - pair.truth.omega_rad) / (cycle * testing::image_s) / degree_rad};
}

TEST(PrintedMethod, AtTheBlockTheTravelOfAStraightDriveIsFourPercentTooLong) {
    const Errors errors = errors_of(Geometry::Block, 0.0);
    EXPECT_NEAR(errors.travel_percent, 3.8, 0.8);
    EXPECT_NEAR(errors.omega_degps, 0.0, 0.03);
}

TEST(PrintedMethod, AtTheBlockATurnMakesItWorseAndSpoilsTheTurnRate) {
    const Errors errors = errors_of(Geometry::Block, 30.0);
    EXPECT_GT(errors.travel_percent, 7.0);
    EXPECT_LT(errors.travel_percent, 13.0);  // depends on the placement of the blocks in the ground window
    EXPECT_NEAR(errors.omega_degps, 0.28, 0.06);
}

TEST(PrintedMethod, AtTheMidPointNoneOfThisIsLeft) {
    for (const double omega_degps : {0.0, 30.0, -30.0}) {
        const Errors errors = errors_of(Geometry::MidPoint, omega_degps);
        EXPECT_LT(std::abs(errors.travel_percent), 0.15);
        EXPECT_LT(std::abs(errors.omega_degps), 0.03);
    }
}

}  // namespace
}  // namespace flownav::motion
