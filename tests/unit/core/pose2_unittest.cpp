#include "flownav/core/pose2.h"

#include <gtest/gtest.h>

namespace flownav {
namespace {

using Eigen::Vector2d;

void expect_same(const Pose2& p, const Pose2& q, double tolerance = 1e-12) {
    EXPECT_NEAR(p.x_m, q.x_m, tolerance);
    EXPECT_NEAR(p.y_m, q.y_m, tolerance);
    EXPECT_NEAR(wrap_angle(p.yaw_rad - q.yaw_rad), 0.0, tolerance);
}

TEST(Pose2, ForwardAfterALeftTurnLeadsToTheLeft) {
    expect_same(compose({1, 2, M_PI / 2}, {3, 0, 0}), {1, 5, M_PI / 2});
    expect_same(compose({0, 0, 0}, {0, 1, 0}), {0, 1, 0});
}

TEST(Pose2, InverseUndoesAPoseFromBothSides) {
    const Pose2 p{1.5, -0.7, 2.9};
    expect_same(compose(p, inverse(p)), {});
    expect_same(compose(inverse(p), p), {});
}

TEST(Pose2, HeadingStaysWithinHalfATurn) {
    const Pose2 p = compose({0, 0, 3.0}, {0, 0, 3.0});
    EXPECT_NEAR(p.yaw_rad, 6.0 - 2 * M_PI, 1e-12);
    EXPECT_NEAR(wrap_angle(-3.5), 2 * M_PI - 3.5, 1e-12);
}

TEST(Pose2, TransformsAPointAsItWouldAPoseThere) {
    const Pose2 a{0.4, -2.0, 0.6};
    const Vector2d p = transform(a, {1.5, 0.3});
    const Pose2 q = compose(a, {1.5, 0.3, 0});
    EXPECT_NEAR(p.x(), q.x_m, 1e-12);
    EXPECT_NEAR(p.y(), q.y_m, 1e-12);
}

TEST(AlongArc, EndsWhereManySmallStepsEnd) {
    constexpr double turn_rad = 0.8, radius_m = 2.0;
    constexpr int steps = 100000;
    Pose2 walked;
    for (int i = 0; i < steps; ++i)
        walked = compose(walked, {radius_m * turn_rad / steps, 0, turn_rad / steps});
    expect_same(along_arc(turn_rad, 2 * radius_m * std::sin(turn_rad / 2)), walked, 1e-4);
}

TEST(AlongArc, TurningLeftLeadsToTheLeftAndBackwardsBehind) {
    EXPECT_GT(along_arc(0.5, 1.0).y_m, 0);
    EXPECT_LT(along_arc(-0.5, 1.0).y_m, 0);
    EXPECT_LT(along_arc(0.0, -1.0).x_m, 0);
    expect_same(along_arc(0.0, 1.0), {1, 0, 0});
}

}  // namespace
}  // namespace flownav
