#include "flownav/core/lens.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/testing/camera.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

/// An equidistant fisheye lens: a ray at the angle a from the axis is shown at the radius k[0] * a.
class Equidistant : public Lens {
  public:
    std::string name() const override { return "equidistant"; }
    bool is_ideal(const LensCoefficients&) const override { return false; }
    Vector2d distort(const Vector2d& ideal, const LensCoefficients& k) const override {
        const double radius = ideal.norm();
        return radius < 1e-9 ? ideal : Vector2d(ideal * (k[0] * std::atan(radius) / radius));
    }
};

CameraModel fisheye_camera() {
    static const bool registered = (register_lens(std::make_shared<Equidistant>()), true);
    EXPECT_TRUE(registered);
    CameraModel camera = testing::standard_camera();
    camera.lens = &find_lens("equidistant");
    camera.distortion = {1.0};
    return camera;
}

TEST(Lens, BrownConradyIsBuiltIn) {
    EXPECT_EQ(lens_names().front(), "brown_conrady");
    EXPECT_EQ(&find_lens("brown_conrady"), &brown_conrady());
    EXPECT_TRUE(has_ideal_lens(testing::standard_camera()));
}

TEST(Lens, ALensOfOnesOwnIsFoundByItsName) {
    const CameraModel camera = fisheye_camera();
    EXPECT_EQ(camera.lens->name(), "equidistant");
    EXPECT_FALSE(has_ideal_lens(camera));
    EXPECT_EQ(lens_names().back(), "equidistant");
}

TEST(Lens, UnusableLensesAreRefused) {
    fisheye_camera();
    EXPECT_THROW(register_lens(nullptr), std::invalid_argument);
    EXPECT_THROW(register_lens(std::make_shared<Equidistant>()), std::invalid_argument);
    EXPECT_THROW(find_lens("pinhole"), std::invalid_argument);
}

TEST(Lens, TheDefaultInverseUndoesTheDistortion) {
    const CameraModel camera = fisheye_camera();
    for (const Vector2d& ideal : {Vector2d(0, 0), Vector2d(0.3, -0.2), Vector2d(-0.8, 0.9)}) {
        const Vector2d shown = camera.lens->distort(ideal, camera.distortion);
        EXPECT_LT((camera.lens->undistort(shown, camera.distortion) - ideal).norm(), 1e-9)
            << ideal.transpose();
    }
}

TEST(Lens, RaysOfACameraPassThroughItsLens) {
    const CameraModel camera = fisheye_camera();
    const RayMapper mapper(camera);
    // The radius of a pixel over the focal length is the angle of its ray.
    const Vector2d ray = mapper.ray({camera.cx_px + 0.5 * camera.fx_px, camera.cy_px});
    EXPECT_NEAR(ray.x(), std::tan(0.5), 1e-9);
    EXPECT_LT((mapper.pixel(ray) - Vector2d(camera.cx_px + 0.5 * camera.fx_px, camera.cy_px)).norm(), 1e-9);
}

TEST(Lens, CamerasOfTwoLensesHaveTwoGeometries) {
    const CameraModel fisheye = fisheye_camera();
    CameraModel other = fisheye;
    EXPECT_TRUE(same_geometry(fisheye, other));
    other.lens = &brown_conrady();
    EXPECT_FALSE(same_geometry(fisheye, other));
}

}  // namespace
}  // namespace flownav
