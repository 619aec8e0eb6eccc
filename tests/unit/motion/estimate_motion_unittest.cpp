#include "flownav/motion/estimate_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exact_samples.h"
#include "flownav/math/units.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/scene.h"

namespace flownav::motion {
namespace {

using testing::drive;
using testing::estimate;
using testing::exact_samples;
using testing::Pair;

constexpr int cycle = 4;
constexpr double cycle_s = cycle * testing::image_s;

/// Errors of an estimate: turn rate, and travel relative to the true one.
double omega_error_degps(const Pair& pair, const MotionEstimate& found) {
    return (found.motion.omega_rad - pair.truth.omega_rad) / cycle_s / degree_rad;
}
double travel_error_percent(const Pair& pair, const MotionEstimate& found) {
    return 100.0 * (found.motion.forward_m / pair.truth.forward_m - 1.0);
}

void expect_truth(const Pair& pair, double omega_degps = 0.03, double travel_percent = 0.15) {
    const MotionEstimate found = estimate(pair, exact_samples(pair));
    EXPECT_TRUE(found.motion.omega_measured);
    EXPECT_TRUE(found.motion.forward_measured);
    EXPECT_LT(std::abs(omega_error_degps(pair, found)), omega_degps);
    EXPECT_LT(std::abs(travel_error_percent(pair, found)), travel_percent);
    EXPECT_LT(std::abs(found.motion.pitch_rad - pair.truth.pitch_rad) / cycle_s / degree_rad, 0.05);
}

TEST(EstimateMotion, FindsAStraightDriveOverFloor) {
    expect_truth(drive(testing::standard_camera(), 0.4, 0.0, cycle));
}

TEST(EstimateMotion, FindsTurnsOf30DegreesASecond) {
    expect_truth(drive(testing::standard_camera(), 0.4, 30.0, cycle));
    expect_truth(drive(testing::standard_camera(), 0.4, -30.0, cycle));
}

TEST(EstimateMotion, TurningLeftIsPositiveAndRightNegative) {
    const Pair left = drive(testing::standard_camera(), 0.4, 10.0, cycle);
    const Pair right = drive(testing::standard_camera(), 0.4, -10.0, cycle);
    EXPECT_GT(estimate(left, exact_samples(left)).motion.omega_rad, 0.02);
    EXPECT_LT(estimate(right, exact_samples(right)).motion.omega_rad, -0.02);
}

TEST(EstimateMotion, ForwardIsPositiveAndBackwardNegative) {
    const Pair forward = drive(testing::standard_camera(), 0.4, 0.0, cycle);
    const Pair backward = drive(testing::standard_camera(), -0.4, 0.0, cycle);
    EXPECT_GT(estimate(forward, exact_samples(forward)).motion.forward_m, 0.06);
    EXPECT_LT(estimate(backward, exact_samples(backward)).motion.forward_m, -0.06);
}

TEST(EstimateMotion, RaisingTheNoseIsAPositivePitch) {
    Pair pair = drive(testing::standard_camera(), 0.4, 5.0, cycle);
    pair.to.camera.mount.pitch_rad -= 0.2 * degree_rad;
    const MotionEstimate found = estimate(pair, exact_samples(pair));
    EXPECT_NEAR(found.motion.pitch_rad, 0.2 * degree_rad, 0.01 * degree_rad);
    EXPECT_NEAR(omega_error_degps(pair, found), 0.0, 0.1);
}

TEST(EstimateMotion, WithoutThePitchInTheModelAVibrationSpoilsTheTurn) {
    Pair pair = drive(testing::standard_camera(), 0.4, 0.0, cycle, {}, {});
    pair.to.camera.mount.pitch_rad -= 0.2 * degree_rad;
    MotionParams yaw_only;
    yaw_only.model = MotionModel::Yaw;
    const MotionEstimate found = estimate(pair, exact_samples(pair), yaw_only);
    EXPECT_EQ(found.motion.pitch_rad, 0.0);
    EXPECT_GT(std::abs(travel_error_percent(pair, found)), 1.0);
}

TEST(EstimateMotion, KnowsACameraAheadOfTheAxis) {
    CameraModel camera = testing::standard_camera();
    camera.mount.forward_m = 0.2;
    expect_truth(drive(camera, 0.4, 30.0, cycle), 0.05, 0.2);
    expect_truth(drive(camera, 0.4, -30.0, cycle), 0.05, 0.2);
}

TEST(EstimateMotion, KnowsACameraBesideTheAxis) {
    for (const double left_m : {0.2, -0.2}) {
        CameraModel camera = testing::standard_camera();
        camera.mount.left_m = left_m;
        expect_truth(drive(camera, 0.4, 30.0, cycle), 0.05, 0.2);
    }
}

TEST(EstimateMotion, KnowsARolledCamera) {
    CameraModel camera = testing::standard_camera();
    camera.mount.roll_rad = 2.0 * degree_rad;
    expect_truth(drive(camera, 0.4, 20.0, cycle));
}

TEST(EstimateMotion, KnowsAWideLens) {
    CameraModel camera = testing::standard_camera();
    camera.fx_px = camera.fy_px = 360.0;  // about 100 degrees across
    camera.distortion = {-0.25, 0.05, 0.0, 0.0, 0.0};
    expect_truth(drive(camera, 0.4, 20.0, cycle));
}

TEST(EstimateMotion, ObstaclesDoNotDisturbIt) {
    const testing::Scene scene = testing::make_scene(testing::SceneKind::Straight, 3);
    ASSERT_FALSE(scene.world.solids.empty());
    expect_truth(drive(testing::standard_camera(), 0.4, 15.0, cycle, scene.world, scene.poses[10]));
}

TEST(EstimateMotion, ThirtyPercentWildVectorsDoNotDisturbIt) {
    const Pair pair = drive(testing::standard_camera(), 0.4, 20.0, cycle);
    std::vector<FlowVector> vectors = testing::exact_vectors(pair);
    sim::HashRandom random(5);
    for (FlowVector& v : vectors) {
        if (random.uniform(0, 1) < 0.3)
            v.flow_px += Eigen::Vector2d(random.uniform(-8, 8), random.uniform(-8, 8));
    }
    const MotionEstimate found = estimate(pair, testing::samples_of(pair, vectors));
    EXPECT_LT(std::abs(omega_error_degps(pair, found)), 0.1);
    EXPECT_LT(std::abs(travel_error_percent(pair, found)), 0.5);
    EXPECT_LT(found.motion.inliers, 0.85 * static_cast<double>(vectors.size()));
    EXPECT_GT(found.motion.inliers, 0.65 * static_cast<double>(vectors.size()));
}

TEST(EstimateMotion, ItsDeviationsAreThoseOfItsErrors) {
    const Pair pair = drive(testing::standard_camera(), 0.4, 10.0, cycle);
    const std::vector<FlowVector> exact = testing::exact_vectors(pair);
    sim::HashRandom random(8);
    double omega2 = 0.0, travel2 = 0.0;
    constexpr int runs = 60;
    for (int run = 0; run < runs; ++run) {
        std::vector<FlowVector> noisy = exact;
        for (FlowVector& v : noisy) v.flow_px += Eigen::Vector2d(random.normal(0.3), random.normal(0.3));
        const EgoMotion m = estimate(pair, testing::samples_of(pair, noisy)).motion;
        omega2 += std::pow((m.omega_rad - pair.truth.omega_rad) / m.sigma_omega_rad, 2) / runs;
        travel2 += std::pow((m.forward_m - pair.truth.forward_m) / m.sigma_forward_m, 2) / runs;
    }
    EXPECT_NEAR(std::sqrt(omega2), 1.0, 0.35);
    EXPECT_NEAR(std::sqrt(travel2), 1.0, 0.5);
}

TEST(EstimateMotion, NoiseFactorTellsHowWrongTheDeviationsAre) {
    const Pair pair = drive(testing::standard_camera(), 0.4, 10.0, cycle);
    std::vector<FlowVector> noisy = testing::exact_vectors(pair);
    sim::HashRandom random(9);
    for (FlowVector& v : noisy) v.flow_px += Eigen::Vector2d(random.normal(0.6), random.normal(0.6));
    EXPECT_NEAR(estimate(pair, testing::samples_of(pair, noisy)).noise_factor, 2.0, 0.3);
}

TEST(EstimateMotion, WithoutSamplesItIsThePredictionAndNothingIsMeasured) {
    MotionScratch scratch;
    const MotionEstimate found =
        estimate_motion({}, testing::standard_camera(), {0.1, -0.02, 0.05}, {}, scratch);
    EXPECT_EQ(found.motion.omega_rad, 0.1);
    EXPECT_EQ(found.motion.pitch_rad, -0.02);
    EXPECT_EQ(found.motion.forward_m, 0.05);
    EXPECT_FALSE(found.motion.omega_measured);
    EXPECT_FALSE(found.motion.forward_measured);
    EXPECT_EQ(found.motion.inliers, 0);
}

TEST(EstimateMotion, AFewVectorsFarApartAreBelievedAgainstAWrongPrediction) {
    const Pair pair = drive(testing::standard_camera(), 0.4, 20.0, cycle);
    const std::vector<MotionSample> all = exact_samples(pair);
    std::vector<MotionSample> few;
    for (std::size_t i = 0; i < all.size(); i += 60) few.push_back(all[i]);
    MotionPrediction straight;
    straight.forward_m = pair.truth.forward_m;
    MotionScratch scratch;
    const MotionEstimate found = estimate_motion(few, pair.from.camera, straight, {}, scratch);
    EXPECT_LT(std::abs(omega_error_degps(pair, found)), 0.1);
}

TEST(EstimateMotion, TravelComesFromTheNearFloorWhenTheGroundWindowIsEmpty) {
    const Pair pair = drive(testing::standard_camera(), 0.4, 20.0, cycle);
    std::vector<MotionSample> samples = exact_samples(pair);
    for (MotionSample& s : samples) s.in_ground_window = false;
    const MotionEstimate found = estimate(pair, samples);
    EXPECT_TRUE(found.motion.forward_measured);
    EXPECT_LT(std::abs(travel_error_percent(pair, found)), 0.1);
}

TEST(EstimateMotion, WithoutNearFloorTravelIsThePredictionButTheTurnIsMeasured) {
    const Pair pair = drive(testing::standard_camera(), 0.4, 20.0, cycle);
    const PlaneGeometry plane(pair.from.camera.mount);
    std::vector<MotionSample> far;
    for (const MotionSample& s : exact_samples(pair))
        if (plane.below_horizon(s.ray.at) < 0.35) far.push_back(s);
    ASSERT_GT(far.size(), 100U);
    const MotionEstimate found = estimate(pair, far);
    EXPECT_TRUE(found.motion.omega_measured);
    EXPECT_FALSE(found.motion.forward_measured);
    EXPECT_EQ(found.motion.forward_m, 0.8 * pair.truth.forward_m);
    EXPECT_LT(std::abs(omega_error_degps(pair, found)), 0.05);
}

TEST(OmegaOf, GivesTheTurnOfASingleVector) {
    const Pair pair = drive(testing::standard_camera(), 0.4, 20.0, 1);
    const PlaneGeometry plane(pair.from.camera.mount);
    for (const MotionSample& s : exact_samples(pair)) {
        if (plane.below_horizon(s.ray.at) < 0.06) continue;
        EXPECT_NEAR(omega_of(s.ray, plane, {1, 0}), pair.truth.omega_rad, 2e-4);
    }
}

}  // namespace
}  // namespace flownav::motion
