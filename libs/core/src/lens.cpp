#include "flownav/core/lens.h"

#include <Eigen/LU>
#include <cmath>

#include "flownav/core/registry.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

/// Inverse of a distortion by Newton steps with a numeric Jacobian: converges on wide lenses too, where a
/// fixed point iteration is slow.
template <class Distort>
Vector2d inverse_by_newton(const Distort& distorted_of, const Vector2d& distorted) {
    constexpr double step = 1e-6;
    Vector2d p = distorted;
    for (int i = 0; i < 12; ++i) {
        const Vector2d residual = distorted_of(p) - distorted;
        if (residual.squaredNorm() < 1e-22) break;
        Eigen::Matrix2d J;
        J.col(0) = (distorted_of(p + Vector2d(step, 0)) - distorted_of(p - Vector2d(step, 0))) / (2 * step);
        J.col(1) = (distorted_of(p + Vector2d(0, step)) - distorted_of(p - Vector2d(0, step))) / (2 * step);
        const double det = J.determinant();
        if (std::abs(det) < 1e-9) break;
        p -= Vector2d(J(1, 1) * residual.x() - J(0, 1) * residual.y(),
                      J(0, 0) * residual.y() - J(1, 0) * residual.x()) /
             det;
    }
    return p;
}

Vector2d distorted_by_brown_conrady(const Vector2d& p, const LensCoefficients& k) {
    const double r2 = p.squaredNorm();
    const double radial = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
    const double xy2 = 2.0 * p.x() * p.y();
    return {p.x() * radial + k[2] * xy2 + k[3] * (r2 + 2.0 * p.x() * p.x()),
            p.y() * radial + k[2] * (r2 + 2.0 * p.y() * p.y()) + k[3] * xy2};
}

/// Brown-Conrady as OpenCV defines it.
class BrownConrady : public Lens {
  public:
    std::string name() const override { return "brown_conrady"; }

    bool is_ideal(const LensCoefficients& k) const override { return k == LensCoefficients{}; }

    Vector2d distort(const Vector2d& ideal, const LensCoefficients& k) const override {
        return distorted_by_brown_conrady(ideal, k);
    }

    Vector2d undistort(const Vector2d& distorted, const LensCoefficients& k) const override {
        return inverse_by_newton([&k](const Vector2d& p) { return distorted_by_brown_conrady(p, k); },
                                 distorted);
    }
};

using LensPointer = std::shared_ptr<const Lens>;

/// The lenses of this program. Not owned by the registry: the built-in ones.
Registry<LensPointer>& lenses() {
    static Registry<LensPointer> all("lens", {{brown_conrady().name(), {LensPointer{}, &brown_conrady()}}});
    return all;
}

}  // namespace

Vector2d Lens::undistort(const Vector2d& distorted, const LensCoefficients& k) const {
    return inverse_by_newton([this, &k](const Vector2d& p) { return distort(p, k); }, distorted);
}

const Lens& brown_conrady() {
    static const BrownConrady lens;
    return lens;
}

void register_lens(std::shared_ptr<const Lens> lens) {
    if (!lens) throw std::invalid_argument("register_lens: there is no lens");
    const std::string name = lens->name();
    lenses().add(name, std::move(lens));
}

const Lens& find_lens(const std::string& name) {
    return *lenses().find(name);
}

std::vector<std::string> lens_names() {
    return lenses().names();
}

}  // namespace flownav
