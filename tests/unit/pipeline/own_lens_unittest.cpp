#include <gtest/gtest.h>

#include <cmath>

#include "drives.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

/// An equidistant fisheye lens: a ray at the angle a from the axis is shown at the radius a.
class Equidistant : public Lens {
  public:
    std::string name() const override { return "equidistant"; }
    bool is_ideal(const LensCoefficients&) const override { return false; }
    Eigen::Vector2d distort(const Eigen::Vector2d& ideal, const LensCoefficients&) const override {
        const double radius = ideal.norm();
        return radius < 1e-9 ? ideal : Eigen::Vector2d(ideal * (std::atan(radius) / radius));
    }
};

double worst_turn_degps(const std::vector<pipeline::Step>& steps, double truth_degps) {
    double worst = 0.0;
    for (std::size_t i = 2; i < steps.size(); ++i)
        worst = std::max(worst, std::abs(deg(steps[i].omega_radps) - truth_degps));
    return worst;
}

TEST(OwnLens, TheMotionBehindARegisteredLensIsMeasured) {
    register_lens(std::make_shared<Equidistant>());
    testing::DriveOptions options;
    options.images = 7;
    options.omega_degps = 10.0;
    options.camera.lens = &find_lens("equidistant");
    auto fields = render_fields(testing::drive(options));
    EXPECT_LT(worst_turn_degps(testing::run(fields), 10.0), 0.6);
    for (Field& field : fields) field.camera.lens = &brown_conrady();
    EXPECT_GT(worst_turn_degps(testing::run(fields), 10.0), 0.6);
}

}  // namespace
}  // namespace flownav
