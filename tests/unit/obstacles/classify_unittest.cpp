#include "flownav/obstacles/classify.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/testing/camera.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

const CameraModel camera = testing::standard_camera();
const PlaneGeometry plane(camera.mount);
const Vector2d near_floor(0.15, 0.2);
constexpr double sigma_px = 0.1;

/// A precisely known motion of one cycle, turning left.
EgoMotion turning_drive() {
    EgoMotion m;
    m.omega_rad = 0.05;
    m.pitch_rad = 0.002;
    m.forward_m = 0.064;
    m.omega_measured = m.forward_measured = true;
    return m;
}

/// Eq. (3) without rotation: the vector of a point at `inverse_depth`, lengthened by `longer_px` along e and
/// moved by `beside_px` across it.
RayFlow vector_of(const Vector2d& at, double inverse_depth, const EgoMotion& m, double longer_px = 0.0,
                  double beside_px = 0.0) {
    const Vector2d e = m.forward_m * plane.e(at);
    const Vector2d along = e.normalized();
    const Vector2d across(-along.y(), along.x());
    RayFlow ray;
    ray.at = at;
    ray.flow = inverse_depth * e + (longer_px * along + beside_px * across) / camera.fx_px;
    ray.sigma = Vector2d(sigma_px, sigma_px) / camera.fx_px;
    return ray;
}

RayFlow floor_vector(double longer_px = 0.0, double beside_px = 0.0) {
    return vector_of(near_floor, plane.ground_inverse_depth(near_floor), turning_drive(), longer_px,
                     beside_px);
}

Classification judged(const RayFlow& ray, const EgoMotion& motion = turning_drive(),
                      double noise_factor = 1.0) {
    return classify(ray, {camera, motion, noise_factor}, {});
}

TEST(Judge, AVectorAsLongAsOnTheGroundIsGround) {
    const Classification j = judged(floor_vector());
    EXPECT_EQ(j.label, BlockLabel::Ground);
    EXPECT_NEAR(j.excess_px, 0.0, 1e-9);
    EXPECT_NEAR(j.inverse_depth, plane.ground_inverse_depth(near_floor), 1e-9);
}

TEST(Judge, AVectorLongerByMoreThanTauIsACandidate) {
    EXPECT_EQ(judged(floor_vector(1.2)).label, BlockLabel::Ground);
    const Classification j = judged(floor_vector(1.3));
    EXPECT_EQ(j.label, BlockLabel::Unsupported);
    EXPECT_NEAR(j.excess_px, 1.3, 1e-9);
}

TEST(Judge, AVectorMuchShorterThanOnTheGroundIsNoGround) {
    EXPECT_EQ(judged(floor_vector(-3.0)).label, BlockLabel::Unjudged);
}

TEST(Judge, SomethingAboveTheHorizonIsACandidateAtItsDepth) {
    const Vector2d at(0.2, -0.55);
    const Classification j = judged(vector_of(at, 1 / 1.5, turning_drive()));
    EXPECT_EQ(j.label, BlockLabel::Unsupported);
    EXPECT_NEAR(1 / j.inverse_depth, 1.5, 1e-9);
}

TEST(Judge, AVectorBesideItsLineIsEliminated) {
    EXPECT_EQ(judged(floor_vector(0.0, 0.9)).label, BlockLabel::Ground);
    EXPECT_EQ(judged(floor_vector(0.0, 1.1)).label, BlockLabel::Eliminated);
    EXPECT_EQ(judged(floor_vector(0.0, -1.1)).label, BlockLabel::Eliminated);
}

TEST(Judge, AVectorTowardsTheFocusOfExpansionIsEliminated) {
    EXPECT_EQ(judged(vector_of(near_floor, -0.5, turning_drive())).label, BlockLabel::Eliminated);
}

TEST(Judge, DrivingBackwardsTheVectorsPointTheOtherWay) {
    EgoMotion back = turning_drive();
    back.forward_m = -back.forward_m;
    const RayFlow ray = vector_of(near_floor, plane.ground_inverse_depth(near_floor), back);
    EXPECT_EQ(judged(ray, back).label, BlockLabel::Ground);
    EXPECT_EQ(judged(ray, turning_drive()).label, BlockLabel::Eliminated);
}

TEST(Judge, AVectorOfLargerDeviationNeedsALargerExcess) {
    RayFlow ray = floor_vector(2.0);
    EXPECT_EQ(judged(ray).label, BlockLabel::Unsupported);
    ray.sigma *= 10.0;  // 1 px: three standard deviations exceed the excess
    EXPECT_NE(judged(ray).label, BlockLabel::Unsupported);
    ray = floor_vector(4.0);
    ray.sigma *= 10.0;
    EXPECT_EQ(judged(ray).label, BlockLabel::Unsupported);
}

TEST(Judge, AnImageOfLargerErrorsNeedsALargerExcess) {
    EXPECT_EQ(judged(floor_vector(2.0), turning_drive(), 1.0).label, BlockLabel::Unsupported);
    EXPECT_NE(judged(floor_vector(2.0), turning_drive(), 10.0).label, BlockLabel::Unsupported);
}

TEST(Judge, WithAnUnknownSpeedNothingIsJudged) {
    EgoMotion motion = turning_drive();
    motion.sigma_forward_m = motion.forward_m;
    EXPECT_EQ(judged(floor_vector(), motion).label, BlockLabel::Unjudged);
    EXPECT_EQ(judged(floor_vector(5.0), motion).label, BlockLabel::Unjudged);
}

TEST(Judge, ARobotThatStandsStillJudgesNothing) {
    const EgoMotion rest;
    EXPECT_EQ(judged(vector_of(near_floor, 1.0, rest), rest).label, BlockLabel::Unjudged);
}

TEST(Judge, FarFloorIsNotEvidence) {
    const Vector2d far(0.3, -0.35);
    EXPECT_EQ(judged(vector_of(far, plane.ground_inverse_depth(far), turning_drive())).label,
              BlockLabel::Unjudged);
}

TEST(Judge, SwingOfACameraAheadOfTheAxisIsPartOfTheTravel) {
    CameraModel ahead = camera;
    ahead.mount.forward_m = 0.3;
    const EgoMotion m = turning_drive();
    const Vector2d e = plane.e(near_floor, {m.forward_m, 0.3 * m.omega_rad});
    RayFlow ray = floor_vector();
    ray.flow = e * plane.ground_inverse_depth(near_floor);
    EXPECT_EQ(classify(ray, {ahead, m, 1.0}, {}).label, BlockLabel::Ground);
    EXPECT_EQ(classify(ray, {camera, m, 1.0}, {}).label, BlockLabel::Eliminated);
}

TEST(Judge, PixelsOfAFieldCountAsTheyAre) {
    const CameraModel field = testing::field_camera(camera, testing::Parity::Top);
    const Vector2d below(0.0, 0.2);  // e points down: one line of a field is two lines of the frame
    RayFlow ray = vector_of(below, plane.ground_inverse_depth(below), turning_drive(), 2.0);
    EXPECT_NEAR(judged(ray).excess_px, 2.0, 1e-9);
    EXPECT_NEAR(classify(ray, {field, turning_drive(), 1.0}, {}).excess_px, 1.0, 1e-9);
}

}  // namespace
}  // namespace flownav::obstacles
