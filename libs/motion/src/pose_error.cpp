#include "flownav/motion/pose_error.h"

#include <Eigen/Dense>
#include <algorithm>

namespace flownav::motion {
namespace {

using Eigen::Matrix3d;

/// Covariance of the angles, with a weak prior at zero correction for angles that the pairs do not determine.
Matrix3d covariance_of(const PoseEquations& e) {
    const Matrix3d A = e.information + Matrix3d::Identity() / (unknown_angle_rad * unknown_angle_rad);
    return A.inverse();
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
    strips += other.strips;
    pairs += other.pairs;
    return *this;
}

PoseCorrection solve(const PoseEquations& e) {
    const Matrix3d covariance = covariance_of(e);
    // The information does not cover errors common to the vectors of a pair; the scatter between pairs does.
    const Matrix3d S = e.scatter - e.gradient * e.gradient.transpose() / std::max(1, e.pairs);
    const Matrix3d between_pairs = covariance * S * covariance;
    return {covariance * e.gradient,
            covariance.diagonal().cwiseMax(between_pairs.diagonal()).cwiseMax(0.0).cwiseSqrt()};
}

MountAngles systematic_sigma_rad(const PoseEquations& e) {
    return (covariance_of(e) * e.strips).rowwise().norm();
}

PoseEquations select(const PoseEquations& equations, const AngleMask& unknown) {
    PoseEquations e = equations;
    for (int i = 0; i < 3; ++i) {
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

}  // namespace flownav::motion
