#include "flownav/core/derotation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"

namespace flownav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

PlaneGeometry plane_25_degrees_down() {
    CameraMount mount;
    mount.pitch_rad = 25 * degree_rad;
    return PlaneGeometry(mount);
}

/// A direction before and after a turn about the vertical, > 0 to the left.
RayFlow turned(const PlaneGeometry& plane, const Vector2d& before, double omega_rad) {
    const Vector3d up(0.0, -plane.a, -plane.b);
    const Vector2d after = (Eigen::AngleAxisd(-omega_rad, up) * Vector3d(before.homogeneous())).hnormalized();
    return {(before + after) / 2, after - before, Vector2d(1e-4, 1e-4)};
}

TEST(Derotation, OfAPureTurnLeavesNothingHoweverLargeItIs) {
    const PlaneGeometry plane = plane_25_degrees_down();
    for (const double omega_rad : {-20 * degree_rad, -2 * degree_rad, 2 * degree_rad, 20 * degree_rad}) {
        const Derotation derotated(plane, omega_rad, 0.0, Geometry::MidPoint);
        for (const Vector2d& at : {Vector2d(0.0, 0.0), Vector2d(0.4, -0.3), Vector2d(-0.3, 0.35)})
            EXPECT_LT(derotated(turned(plane, at, omega_rad)).flow.norm(), 1e-12);
    }
}

TEST(Derotation, ALeftTurnMovesThePictureToTheRight) {
    EXPECT_GT(turned(plane_25_degrees_down(), {0, 0}, 1 * degree_rad).flow.x(), 0.0);
}

TEST(Derotation, OfAPurePitchLeavesNothing) {
    const double pitch_rad = 1 * degree_rad;  // raises the view: the picture moves down
    const Vector2d before(0.2, 0.1);
    const Vector2d after =
        (Eigen::AngleAxisd(-pitch_rad, Vector3d::UnitX()) * Vector3d(before.homogeneous())).hnormalized();
    EXPECT_GT(after.y(), before.y());
    const Derotation derotated(plane_25_degrees_down(), 0.0, pitch_rad, Geometry::MidPoint);
    EXPECT_LT(derotated({(before + after) / 2, after - before, Vector2d::Zero()}).flow.norm(), 1e-12);
}

TEST(Derotation, AgreesWithTheLinearFieldsForSmallTurns) {
    const PlaneGeometry plane = plane_25_degrees_down();
    const RayFlow ray{{0.3, 0.2}, {0.01, 0.02}, {1e-4, 1e-4}};
    const Vector2d exact = Derotation(plane, 1e-4, 2e-4, Geometry::MidPoint)(ray).flow;
    const Vector2d linear = Derotation(plane, 1e-4, 2e-4, Geometry::Block)(ray).flow;
    EXPECT_LT((exact - linear).norm(), 1e-7);
}

TEST(Derotation, WithoutATurnChangesNothing) {
    const RayFlow ray{{0.3, 0.2}, {0.01, 0.02}, {1e-4, 1e-4}};
    for (const Geometry geometry : {Geometry::Block, Geometry::MidPoint}) {
        const RayFlow same = Derotation(plane_25_degrees_down(), 0.0, 0.0, geometry)(ray);
        EXPECT_LT((same.at - ray.at).norm(), 1e-15);
        EXPECT_LT((same.flow - ray.flow).norm(), 1e-15);
    }
}

}  // namespace
}  // namespace flownav
