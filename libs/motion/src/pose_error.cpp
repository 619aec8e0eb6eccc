#include "flownav/motion/pose_error.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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
constexpr int strips = 8;
constexpr int unknowns = angles + PairMotion::size;
constexpr int vectors_min = 24;
constexpr int steps = 4;
constexpr double matching_error_px = 0.02;  // of block matching, in rows of one distance alike
constexpr double rcond_min = 1e-12;
constexpr double far_share = 1.0 / 3.0;    // of a y + b at the lower border
constexpr double aside_max_heights = 2.0;  // beside the robot: roads have edges
constexpr double below_horizon_min_of_all = 0.02;
constexpr double noise_factor_min = 0.3;
constexpr double noise_factor_max = 30.0;
constexpr double close_deviations = 3.5;
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
        : plane(camera.mount), below_horizon_min(near_below_horizon(camera)) {}

    bool shows(const RayFlow& ray) const {
        const double below = plane.below_horizon(ray.at);
        return below >= below_horizon_min && std::abs(ray.at.x()) <= aside_max_heights * below;
    }

    /// 0 for the farthest vectors that count, 1 at the lower border.
    double nearness(const RayFlow& ray) const {
        const double far = below_horizon_min;
        return std::clamp((plane.below_horizon(ray.at) - far) / (far / far_share - far), 0.0, 1.0);
    }
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

/// The pair's equations: adds what a vector says, and removes the pair's own motion (Schur complement).
class Equations {
  public:
    Normal N = Normal::Zero();
    Column g = Column::Zero();

    using Own = Eigen::Matrix<double, PairMotion::size, 1>;

    /// `depth_share`: 0 for the farthest of the near floor, 1 at the lower border; `pixel`: one pixel in the
    /// units of the residual.
    void add(const Jacobian& J, const Vector2d& residual, double weight, double depth_share,
             const Vector2d& pixel) {
        const Column gradient = weight * J.transpose() * residual;
        N.noalias() += weight * J.transpose() * J;
        g += gradient;
        strips_.col(std::clamp(static_cast<int>(depth_share * strips), 0, strips - 1)) += gradient;
        const Vector2d error = matching_error_px * (2.0 * depth_share - 1.0) * pixel;
        strips_.rightCols<2>() += weight * J.transpose() * error.asDiagonal();
    }

    /// What is known of the pair's pitch and roll beforehand.
    void expect(const PairMotion& own, const Steadiness& steadiness) {
        for (const auto& [i, sigma_rad] : {std::pair(PairMotion::pitch, steadiness.pitch_rad),
                                           std::pair(PairMotion::roll, steadiness.roll_rad)}) {
            const double weight = 1.0 / (sigma_rad * sigma_rad);
            N(angles + i, angles + i) += weight;
            g[angles + i] -= weight * own.values[i];
        }
    }

    /// The step of the pair's own motion, with the angles as they are.
    std::optional<Own> own_step() const {
        const Eigen::LDLT<Matrix4d> own(N.bottomRightCorner<PairMotion::size, PairMotion::size>());
        if (own.info() != Eigen::Success || own.rcond() < rcond_min) return std::nullopt;
        return Own(own.solve(g.tail<PairMotion::size>()));
    }

    PoseEquations eliminated() const {
        PoseEquations e;
        const Eigen::LDLT<Matrix4d> own(N.bottomRightCorner<PairMotion::size, PairMotion::size>());
        if (own.info() != Eigen::Success || own.rcond() < rcond_min) return e;
        // Angles and own motion -> angles alone.
        Eigen::Matrix<double, angles, unknowns> E;
        E.leftCols<angles>().setIdentity();
        E.rightCols<PairMotion::size>() =
            -own.solve(N.bottomLeftCorner<PairMotion::size, angles>()).transpose();
        e.information = E * N.leftCols<angles>();
        e.gradient = E * g;
        e.scatter = e.gradient * e.gradient.transpose();
        e.strips = E * strips_;
        e.pairs = 1;
        return e;
    }

  private:
    Eigen::Matrix<double, unknowns, strips + 2> strips_ = Eigen::Matrix<double, unknowns, strips + 2>::Zero();
};

}  // namespace

double near_below_horizon(const CameraModel& camera) {
    const PlaneGeometry plane(camera.mount);
    const double nearest = plane.below_horizon({0.0, (camera.height_px - camera.cy_px) / camera.fy_px});
    return std::max(below_horizon_min_of_all, far_share * nearest);
}

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
    strips += other.strips;
    pairs += other.pairs;
    return *this;
}

PairFit fit_pair(const std::vector<RayFlow>& rays, const CameraModel& camera, const EgoMotion& motion,
                 Geometry geometry, const Steadiness& steadiness, PoseScratch& scratch) {
    PairFit fit;
    PairMotion own(motion, camera.mount.height_m);
    const NearGround near(camera);
    for (int step = 0;; ++step) {
        const Model model = model_at(camera.mount, own);
        fit.H_newer_reference = model.H;
        fit.noise_factor = robust_noise(rays, near, model.H, geometry, scratch);
        if (fit.noise_factor <= 0.0) return {};
        Equations equations;
        equations.expect(own, steadiness);
        fit.near_vectors = fit.close_vectors = fit.ground_vectors = 0;
        for (const RayFlow& ray : rays) {
            if (!near.shows(ray)) continue;
            const Ends ends = ends_of(ray, geometry);
            const Vector2d sigma = ray.sigma * fit.noise_factor;
            const Vector2d residual = residual_of(ends, sigma, model.H);
            const double weight = biweight(residual.norm());
            ++fit.near_vectors;
            fit.close_vectors += residual.norm() * fit.noise_factor < close_deviations;
            fit.ground_vectors += weight > 0.0;
            if (weight > 0.0)
                equations.add(jacobian_of(ends, sigma, model), residual, weight, near.nearness(ray),
                              one_pixel(camera).cwiseQuotient(sigma));
        }
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

PoseCorrection solve(const PoseEquations& e) {
    const Matrix3d A = e.information + Matrix3d::Identity() / (unknown_angle_rad * unknown_angle_rad);
    const Matrix3d covariance = A.inverse();
    // What the vectors' own deviations say knows nothing of errors that a pair's vectors share: the pairs do.
    const Matrix3d S = e.scatter - e.gradient * e.gradient.transpose() / std::max(1, e.pairs);
    const Matrix3d between_pairs = covariance * S * covariance;
    return {covariance * e.gradient,
            covariance.diagonal().cwiseMax(between_pairs.diagonal()).cwiseMax(0.0).cwiseSqrt()};
}

MountAngles systematic_sigma_rad(const PoseEquations& e) {
    const Matrix3d A = e.information + Matrix3d::Identity() / (unknown_angle_rad * unknown_angle_rad);
    const Eigen::Matrix<double, angles, strips + 2> shifts = A.inverse() * e.strips;
    return shifts.rowwise().norm();
}

PoseEquations only(const PoseEquations& equations, const AngleMask& unknown) {
    PoseEquations e = equations;
    for (int i = 0; i < angles; ++i) {
        if (unknown[static_cast<std::size_t>(i)]) continue;
        e.information.row(i).setZero();
        e.information.col(i).setZero();
        e.scatter.row(i).setZero();
        e.scatter.col(i).setZero();
        e.gradient[i] = 0.0;
        e.strips.row(i).setZero();
    }
    return e;
}

}  // namespace flownav
