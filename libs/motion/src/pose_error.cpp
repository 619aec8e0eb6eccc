#include "flownav/motion/pose_error.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "flownav/core/plane_geometry.h"
#include "flownav/motion/robust.h"
#include "ground_homography.h"

namespace flownav {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr int angles = 3;
constexpr int unknowns = angles + PairMotion::size;
constexpr int vectors_min = 24;
constexpr int steps = 6;
constexpr double far_share = 1.0 / 3.0;  // of a y + b at the lower border: what lies beyond is seldom floor
constexpr double noise_factor_min = 0.3;
constexpr double noise_factor_max = 30.0;
constexpr double median_of_norm = 1.1774;  // of a Gaussian in two dimensions of deviation 1

using Normal = Eigen::Matrix<double, unknowns, unknowns>;
using Column = Eigen::Matrix<double, unknowns, 1>;
using Jacobian = Eigen::Matrix<double, 2, unknowns>;

struct Ends {
    Vector2d begin, end;
};

Ends ends_of(const RayFlow& ray, Geometry geometry) {
    const Vector2d begin = geometry == Geometry::MidPoint ? Vector2d(ray.at - ray.flow / 2) : ray.at;
    return {begin, begin + ray.flow};
}

/// The homography of the ground, and its derivatives for all unknowns.
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

/// One vector in units of its deviation: residual, and how the prediction changes with the unknowns.
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
        : plane(camera.mount),
          below_horizon_min(std::max(
              0.02,
              far_share * plane.below_horizon({0.0, (camera.height_px - camera.cy_px) / camera.fy_px}))) {}

    bool shows(const RayFlow& ray) const { return plane.below_horizon(ray.at) >= below_horizon_min; }
};

double robust_noise(const std::vector<RayFlow>& rays, const NearGround& near, const Matrix3d& H,
                    Geometry geometry, PoseScratch& scratch) {
    scratch.values.clear();
    for (const RayFlow& ray : rays)
        if (near.shows(ray))
            scratch.values.push_back(residual_of(ends_of(ray, geometry), ray.sigma, H).norm());
    if (static_cast<int>(scratch.values.size()) < vectors_min) return 0.0;
    const auto middle = scratch.values.begin() + static_cast<std::ptrdiff_t>(scratch.values.size() / 2);
    std::nth_element(scratch.values.begin(), middle, scratch.values.end());
    return std::clamp(*middle / median_of_norm, noise_factor_min, noise_factor_max);
}

/// Removes the pair's own motion from the equations (Schur complement).
PoseEquations eliminated(const Normal& N, const Column& g) {
    const Eigen::LDLT<Matrix4d> own(N.bottomRightCorner<PairMotion::size, PairMotion::size>());
    const Eigen::Matrix<double, PairMotion::size, angles> coupling =
        N.bottomLeftCorner<PairMotion::size, angles>();
    PoseEquations e;
    if (own.info() != Eigen::Success || own.rcond() < 1e-12) return e;
    e.information = N.topLeftCorner<angles, angles>() - coupling.transpose() * own.solve(coupling);
    e.gradient = g.head<angles>() - coupling.transpose() * own.solve(g.tail<PairMotion::size>());
    e.scatter = e.gradient * e.gradient.transpose();
    e.pairs = 1;
    return e;
}

}  // namespace

CameraMount corrected(CameraMount mount, const MountAngles& correction) {
    mount.pitch_rad += correction[0];
    mount.roll_rad += correction[1];
    mount.yaw_rad += correction[2];
    return mount;
}

PoseEquations& PoseEquations::operator+=(const PoseEquations& other) {
    information += other.information;
    gradient += other.gradient;
    scatter += other.scatter;
    pairs += other.pairs;
    return *this;
}

PairFit fit_pair(const std::vector<RayFlow>& rays, const CameraModel& camera, const EgoMotion& motion,
                 Geometry geometry, PoseScratch& scratch) {
    PairFit fit;
    PairMotion own(motion, camera.mount.height_m);
    const NearGround near(camera);
    Normal N;
    Column g;
    for (int step = 0;; ++step) {
        const Model model = model_at(camera.mount, own);
        fit.H_newer_reference = model.H;
        fit.noise_factor = robust_noise(rays, near, model.H, geometry, scratch);
        if (fit.noise_factor <= 0.0) return {};
        N.setZero();
        g.setZero();
        fit.ground_vectors = 0;
        for (const RayFlow& ray : rays) {
            if (!near.shows(ray)) continue;
            const Ends ends = ends_of(ray, geometry);
            const Vector2d sigma = ray.sigma * fit.noise_factor;
            const Vector2d residual = residual_of(ends, sigma, model.H);
            const double weight = biweight(residual.norm());
            if (weight <= 0.0) continue;
            const Jacobian J = jacobian_of(ends, sigma, model);
            N.noalias() += weight * J.transpose() * J;
            g.noalias() += weight * J.transpose() * residual;
            ++fit.ground_vectors;
        }
        if (step == steps) break;
        const Eigen::LDLT<Matrix4d> solver(N.bottomRightCorner<PairMotion::size, PairMotion::size>());
        if (solver.info() != Eigen::Success || solver.rcond() < 1e-12) return {};
        own.values += solver.solve(g.tail<PairMotion::size>());
    }
    if (fit.ground_vectors >= vectors_min) fit.equations = eliminated(N, g);
    return fit;
}

PoseCorrection solve(const PoseEquations& e) {
    const Matrix3d A = e.information + Matrix3d::Identity() / (unknown_angle_rad * unknown_angle_rad);
    const Matrix3d covariance = A.inverse();
    // What the vectors' own deviations say knows nothing of errors that a pair's vectors share: the pairs do.
    const Matrix3d S = e.scatter - e.gradient * e.gradient.transpose() / std::max(1, e.pairs);
    const Matrix3d between_pairs = covariance * S * covariance;
    return {covariance * e.gradient,
            covariance.diagonal().cwiseMax(between_pairs.diagonal()).cwiseMax(0.0).cwiseSqrt()};
}

PoseCorrection solve_pitch(const PoseEquations& e) {
    PoseEquations pitch;
    pitch.information(0, 0) = e.information(0, 0);
    pitch.gradient[0] = e.gradient[0];
    pitch.scatter(0, 0) = e.scatter(0, 0);
    pitch.pairs = e.pairs;
    return solve(pitch);
}

}  // namespace flownav
