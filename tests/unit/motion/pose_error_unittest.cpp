#include "flownav/motion/pose_error.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "exact_samples.h"
#include "flownav/math/units.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/scene.h"

namespace flownav::motion {
namespace {

using testing::Pair;

constexpr int cycle = 4;

/// The rays of a pair under an assumed, wrong mount.
std::vector<RayFlow> rays_of(const Pair& pair, const std::vector<FlowVector>& vectors,
                             const CameraMount& assumed) {
    CameraModel from = pair.from.camera;
    CameraModel to = pair.to.camera;
    from.mount = to.mount = assumed;
    std::vector<RayFlow> rays;
    rays.reserve(vectors.size());
    for (const FlowVector& v : vectors)
        rays.push_back(ray_flow(v, RayMapper(from), RayMapper(to), Geometry::MidPoint));
    return rays;
}

PairFit fit(const Pair& pair, const std::vector<FlowVector>& vectors, const CameraMount& assumed) {
    CameraModel camera = pair.from.camera;
    camera.mount = assumed;
    PoseScratch scratch;
    EgoMotion rough;
    rough.omega_rad = 0.9 * pair.truth.omega_rad;
    rough.forward_m = 0.9 * pair.truth.forward_m;
    return fit_pair(rays_of(pair, vectors, assumed), camera, rough, Geometry::MidPoint, {}, scratch);
}

/// Refines an assumed mount by Gauss-Newton steps on one pair.
CameraMount refined(const Pair& pair, const std::vector<FlowVector>& vectors, CameraMount assumed) {
    for (int i = 0; i < 6; ++i)
        assumed = corrected(assumed, solve(fit(pair, vectors, assumed).equations).correction_rad);
    return assumed;
}

CameraModel camera_with(double pitch_deg, double roll_deg, double yaw_deg) {
    CameraModel camera = testing::standard_camera();
    camera.mount.pitch_rad += pitch_deg * degree_rad;
    camera.mount.roll_rad += roll_deg * degree_rad;
    camera.mount.yaw_rad += yaw_deg * degree_rad;
    return camera;
}

/// Correction found when the true mount differs in one axis from the assumed one.
MountAngles correction_found(double pitch_deg, double roll_deg, double yaw_deg, double omega_degps = 8.0) {
    const Pair pair = testing::drive(camera_with(pitch_deg, roll_deg, yaw_deg), 0.4, omega_degps, cycle);
    const CameraMount found = refined(pair, testing::exact_vectors(pair), testing::standard_camera().mount);
    const CameraMount& start = testing::standard_camera().mount;
    return MountAngles(found.pitch_rad - start.pitch_rad, found.roll_rad - start.roll_rad,
                       found.yaw_rad - start.yaw_rad) /
           degree_rad;
}

TEST(PoseError, ACameraThatLooksFartherDownThanAssumedHasAPositivePitchError) {
    const MountAngles found = correction_found(1.0, 0.0, 0.0);
    EXPECT_NEAR(found[0], 1.0, 0.005);
    EXPECT_NEAR(found[1], 0.0, 0.005);
    EXPECT_NEAR(found[2], 0.0, 0.01);
}

TEST(PoseError, ACameraThatIsTiltedToItsRightHasAPositiveRollError) {
    const MountAngles found = correction_found(0.0, 2.0, 0.0);
    EXPECT_NEAR(found[0], 0.0, 0.005);
    EXPECT_NEAR(found[1], 2.0, 0.005);
    EXPECT_NEAR(found[2], 0.0, 0.01);
}

TEST(PoseError, ACameraThatLooksToTheLeftHasAPositiveYawError) {
    const MountAngles found = correction_found(0.0, 0.0, 1.5);
    EXPECT_NEAR(found[0], 0.0, 0.005);
    EXPECT_NEAR(found[1], 0.0, 0.005);
    EXPECT_NEAR(found[2], 1.5, 0.01);
}

TEST(PoseError, AllAnglesAreFoundTogetherFromFarOff) {
    const MountAngles found = correction_found(-6.0, 3.0, -2.0);
    EXPECT_NEAR(found[0], -6.0, 0.005);
    EXPECT_NEAR(found[1], 3.0, 0.005);
    EXPECT_NEAR(found[2], -2.0, 0.01);
}

/// Flow of the floor, with a third of the vectors on nearer objects, and noise.
std::vector<FlowVector> with_obstacles(const Pair& pair, sim::HashRandom& random) {
    std::vector<FlowVector> vectors = testing::exact_vectors(pair);
    for (FlowVector& v : vectors) {
        if (v.at_px.x() > 400.0) v.flow_px *= 1.3;
        v.flow_px += Eigen::Vector2d(random.normal(0.1), random.normal(0.1));
    }
    return vectors;
}

TEST(PoseError, VectorsThatDoNotMoveLikeTheFloorAreRejected) {
    const Pair pair = testing::drive(camera_with(1.0, 0.0, 0.0), 0.4, 8.0, cycle);
    sim::HashRandom random(3);
    PoseEquations sum;
    for (int run = 0; run < 30; ++run)
        sum += fit(pair, with_obstacles(pair, random), pair.from.camera.mount).equations;
    EXPECT_NEAR(solve(sum).correction_rad[0] / degree_rad, 0.0, 0.08);
}

TEST(PoseError, TheDeviationIsThatOfTheErrors) {
    const Pair pair = testing::drive(testing::standard_camera(), 0.4, 8.0, cycle);
    sim::HashRandom random(4);
    double pulls2 = 0.0;
    constexpr int runs = 60;
    for (int run = 0; run < runs; ++run) {
        std::vector<FlowVector> noisy = testing::exact_vectors(pair);
        for (FlowVector& v : noisy) v.flow_px += Eigen::Vector2d(random.normal(0.3), random.normal(0.3));
        const PoseCorrection found =
            solve(select(fit(pair, noisy, pair.from.camera.mount).equations, {true, false, false}));
        pulls2 += std::pow(found.correction_rad[0] / found.sigma_rad[0], 2) / runs;
    }
    EXPECT_NEAR(std::sqrt(pulls2), 1.0, 0.35);
}

TEST(PoseError, ARobotThatOnlyTurnsDoesNotTellThePose) {
    const Pair pair = testing::drive(testing::standard_camera(), 0.0, 20.0, cycle);
    const PoseCorrection found =
        solve(fit(pair, testing::exact_vectors(pair), testing::standard_camera().mount).equations);
    EXPECT_GT(found.sigma_rad[0], 2.0 * degree_rad);
    EXPECT_LT(std::abs(found.correction_rad[0]), 0.2 * degree_rad);
}

TEST(PoseError, TooFewVectorsGiveNoEquations) {
    const Pair pair = testing::drive(testing::standard_camera(), 0.4, 0.0, cycle);
    std::vector<FlowVector> few = testing::exact_vectors(pair);
    few.resize(10);
    EXPECT_EQ(fit(pair, few, pair.from.camera.mount).equations.pairs, 0);
    EXPECT_EQ(fit(pair, {}, pair.from.camera.mount).equations.pairs, 0);
}

TEST(PoseError, TheModelIsExactForFiniteMotionAndACameraOffTheAxis) {
    CameraModel camera = camera_with(0.0, 1.0, -0.5);
    camera.mount.forward_m = 0.3;
    camera.mount.left_m = -0.1;
    Pair pair = testing::drive(camera, 0.5, 30.0, cycle);
    pair.to.camera.mount.pitch_rad -= 0.1 * degree_rad;
    const PairFit found = fit(pair, testing::exact_vectors(pair), pair.from.camera.mount);
    const RayMapper from(pair.from.camera);
    for (const FlowVector& v : testing::exact_vectors(pair)) {
        const Eigen::Vector2d end = (found.H_newer_reference * from.ray(v.at_px).homogeneous()).hnormalized();
        EXPECT_LT((from.pixel(end) - v.at_px - v.flow_px).norm(), 0.05);
    }
}

}  // namespace
}  // namespace flownav::motion
