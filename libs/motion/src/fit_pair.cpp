#include <algorithm>
#include <cmath>

#include "flownav/core/plane_geometry.h"
#include "flownav/motion/pose_error.h"
#include "flownav/motion/robust.h"
#include "ground_homography.h"
#include "pair_equations.h"

namespace flownav::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Jacobian = PairEquations::Jacobian;

constexpr int angles = PairEquations::angles;
constexpr int unknowns = PairEquations::unknowns;
constexpr int vectors_min = 24;
constexpr int steps = 4;
constexpr double far_share = 1.0 / 3.0;  // share of a y + b at the lower border
constexpr double aside_max_heights =
    2.0;  // in camera heights, to either side of the optical axis: roads have edges
constexpr double below_horizon_min_of_all = 0.02;
constexpr double noise_factor_min = 0.3;
constexpr double noise_factor_max = 30.0;
constexpr double close_deviations = 3.5;
constexpr double median_of_norm = 1.1774;  // of a two-dimensional Gaussian with deviation 1

struct Ends {
    Vector2d begin, end;
};

Ends ends_of(const RayFlow& ray, Geometry geometry) {
    const Vector2d begin = geometry == Geometry::MidPoint ? Vector2d(ray.at - ray.flow / 2) : ray.at;
    return {begin, begin + ray.flow};
}

/// Homography of the ground and its derivatives by all unknowns.
struct Model {
    Matrix3d H;
    std::array<Matrix3d, unknowns> dH;
};

Model model_at(const CameraMount& mount, const PairMotion& motion) {
    constexpr double h = 1e-5;
    Model model{ground_homography(mount, MountAngles::Zero(), motion), {}};
    for (int i = 0; i < unknowns; ++i) {
        MountAngles angle = MountAngles::Zero();
        PairMotion plus = motion, minus = motion;
        if (i < angles) {
            angle[i] = h;
        } else {
            plus.values[i - angles] += h;
            minus.values[i - angles] -= h;
        }
        model.dH[static_cast<std::size_t>(i)] =
            (ground_homography(mount, angle, plus) - ground_homography(mount, -angle, minus)) / (2 * h);
    }
    return model;
}

/// Residual of one vector in units of its standard deviation.
Vector2d residual_of(const Ends& ends, const Vector2d& sigma, const Matrix3d& H) {
    return (ends.end - (H * ends.begin.homogeneous()).hnormalized()).cwiseQuotient(sigma);
}

Jacobian jacobian_of(const Ends& ends, const Vector2d& sigma, const Model& model) {
    const Vector3d r = ends.begin.homogeneous();
    const Vector3d p = model.H * r;
    const Vector2d q = p.hnormalized();
    Jacobian J;
    for (int i = 0; i < unknowns; ++i) {
        const Vector3d d = model.dH[static_cast<std::size_t>(i)] * r;
        J.col(i) = ((d.head<2>() - q * d.z()) / p.z()).cwiseQuotient(sigma);
    }
    return J;
}

struct NearGround {
    PlaneGeometry plane;
    double below_horizon_min;

    explicit NearGround(const CameraModel& camera)
        : plane(camera.mount), below_horizon_min(near_below_horizon(camera)) {}

    bool shows(const RayFlow& ray) const {
        const double below = plane.below_horizon(ray.at);
        return below >= below_horizon_min && std::abs(ray.at.x()) <= aside_max_heights * below;
    }

    /// Share of the way from the farthest near ground (0) to the lower border (1).
    double nearness(const RayFlow& ray) const {
        const double far = below_horizon_min;
        return std::clamp((plane.below_horizon(ray.at) - far) / (far / far_share - far), 0.0, 1.0);
    }
};

double robust_noise(const std::vector<RayFlow>& rays, const NearGround& near, const Matrix3d& H,
                    Geometry geometry, PoseScratch& scratch) {
    scratch.values.clear();
    for (const RayFlow& ray : rays) {
        if (!near.shows(ray)) continue;
        scratch.values.push_back(residual_of(ends_of(ray, geometry), ray.sigma, H).norm());
    }
    if (static_cast<int>(scratch.values.size()) < vectors_min) return 0.0;
    const auto middle = scratch.values.begin() + static_cast<std::ptrdiff_t>(scratch.values.size() / 2);
    std::nth_element(scratch.values.begin(), middle, scratch.values.end());
    return std::clamp(*middle / median_of_norm, noise_factor_min, noise_factor_max);
}

/// Sets up the equations at the current motion and counts the agreeing vectors in `fit`.
PairEquations equations_at(const Model& model, const std::vector<RayFlow>& rays, const CameraModel& camera,
                           Geometry geometry, PairFit& fit) {
    const NearGround near(camera);
    PairEquations equations;
    fit.near_vectors = fit.close_vectors = fit.ground_vectors = 0;
    for (const RayFlow& ray : rays) {
        if (!near.shows(ray)) continue;
        const Ends ends = ends_of(ray, geometry);
        const Vector2d sigma = ray.sigma * fit.noise_factor;
        const Vector2d residual = residual_of(ends, sigma, model.H);
        const double weight = biweight(residual.norm());
        ++fit.near_vectors;
        fit.close_vectors += residual.norm() * fit.noise_factor < close_deviations;
        if (weight <= 0.0) continue;
        ++fit.ground_vectors;
        equations.add(jacobian_of(ends, sigma, model), residual, weight, near.nearness(ray),
                      one_pixel(camera).cwiseQuotient(sigma));
    }
    return equations;
}

}  // namespace

double near_below_horizon(const CameraModel& camera) {
    const PlaneGeometry plane(camera.mount);
    const double nearest = plane.below_horizon({0.0, (camera.height_px - camera.cy_px) / camera.fy_px});
    return std::max(below_horizon_min_of_all, far_share * nearest);
}

PairFit fit_pair(const std::vector<RayFlow>& rays, const CameraModel& camera, const EgoMotion& motion,
                 Geometry geometry, const PitchPrior& pitch_prior, PoseScratch& scratch) {
    PairFit fit;
    PairMotion own(motion, camera.mount.height_m);
    for (int step = 0;; ++step) {
        const Model model = model_at(camera.mount, own);
        fit.H_newer_reference = model.H;
        fit.noise_factor = robust_noise(rays, NearGround(camera), model.H, geometry, scratch);
        if (fit.noise_factor <= 0.0) return {};
        PairEquations equations = equations_at(model, rays, camera, geometry, fit);
        equations.expect(own, pitch_prior);
        if (step == steps) {
            if (fit.ground_vectors >= vectors_min) fit.equations = equations.eliminated();
            break;
        }
        const auto own_step = equations.own_step();
        if (!own_step) return {};
        own.values += *own_step;
    }
    fit.pitch_rad = own.pitch_rad();
    fit.roll_rad = own.roll_rad();
    return fit;
}

}  // namespace flownav::motion
