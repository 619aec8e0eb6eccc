#pragma once
#include <Eigen/Dense>
#include <algorithm>
#include <optional>
#include <utility>

#include "flownav/motion/pose_error.h"
#include "ground_homography.h"

namespace flownav::motion {

/// Normal equations of one pair: the camera's angles first, then the pair's own motion.
class PairEquations {
  public:
    static constexpr int angles = 3;
    static constexpr int unknowns = angles + PairMotion::size;
    using Jacobian = Eigen::Matrix<double, 2, unknowns>;
    using Own = Eigen::Matrix<double, PairMotion::size, 1>;

    /// Adds one vector. `depth_share`: 0 at the farthest near floor, 1 at the lower border; `pixel`: size of
    /// one pixel in the units of the residual.
    void add(const Jacobian& J, const Eigen::Vector2d& residual, double weight, double depth_share,
             const Eigen::Vector2d& pixel) {
        const Column gradient = weight * J.transpose() * residual;
        N_.noalias() += weight * J.transpose() * J;
        g_ += gradient;
        strips_.col(std::clamp(static_cast<int>(depth_share * strips), 0, strips - 1)) += gradient;
        const Eigen::Vector2d error = matching_error_px * (2.0 * depth_share - 1.0) * pixel;
        strips_.rightCols<2>() += weight * J.transpose() * error.asDiagonal();
    }

    /// Adds the prior of the pair's pitch and roll: mean zero, deviations of `pitch_prior`.
    void expect(const PairMotion& own, const PitchPrior& pitch_prior) {
        for (const auto& [i, sigma_rad] : {std::pair(PairMotion::pitch, pitch_prior.pitch_rad),
                                           std::pair(PairMotion::roll, pitch_prior.roll_rad)}) {
            const double weight = 1.0 / (sigma_rad * sigma_rad);
            N_(angles + i, angles + i) += weight;
            g_[angles + i] -= weight * own.values[i];
        }
    }

    /// Returns the Gauss-Newton step of the pair's own motion at fixed angles; empty when it is not
    /// determined.
    std::optional<Own> own_step() const {
        const Eigen::LDLT<Eigen::Matrix4d> own(N_.bottomRightCorner<PairMotion::size, PairMotion::size>());
        if (own.info() != Eigen::Success || own.rcond() < rcond_min) return std::nullopt;
        return Own(own.solve(g_.tail<PairMotion::size>()));
    }

    /// Returns the equations of the angles alone (Schur complement); no pairs when the pair's own motion is
    /// not determined.
    PoseEquations eliminated() const {
        PoseEquations e;
        const Eigen::LDLT<Eigen::Matrix4d> own(N_.bottomRightCorner<PairMotion::size, PairMotion::size>());
        if (own.info() != Eigen::Success || own.rcond() < rcond_min) return e;
        // E maps equations of angles and own motion to equations of the angles.
        Eigen::Matrix<double, angles, unknowns> E;
        E.leftCols<angles>().setIdentity();
        E.rightCols<PairMotion::size>() =
            -own.solve(N_.bottomLeftCorner<PairMotion::size, angles>()).transpose();
        e.information = E * N_.leftCols<angles>();
        e.gradient = E * g_;
        e.scatter = e.gradient * e.gradient.transpose();
        e.strips = E * strips_;
        e.pairs = 1;
        return e;
    }

  private:
    static constexpr int strips = 8;
    static constexpr double matching_error_px =
        0.02;  // of block matching; equal for all vectors of one distance
    static constexpr double rcond_min = 1e-12;
    using Normal = Eigen::Matrix<double, unknowns, unknowns>;
    using Column = Eigen::Matrix<double, unknowns, 1>;

    Normal N_ = Normal::Zero();
    Column g_ = Column::Zero();
    Eigen::Matrix<double, unknowns, strips + 2> strips_ = Eigen::Matrix<double, unknowns, strips + 2>::Zero();
};

}  // namespace flownav::motion
