#include "pose_uncertainty.h"

#include <cmath>

namespace flownav::pipeline {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Relative error of all travel: height and pitch of the camera, size of the wheels.
constexpr double scale = 0.01;

}  // namespace

void PoseUncertainty::move(const Pose2& T_start_reference, const EgoMotion& motion) {
    const Pose2 T_reference_robot = pose_after(motion);
    const double c = std::cos(T_start_reference.yaw_rad);
    const double s = std::sin(T_start_reference.yaw_rad);
    const double x_m = c * T_reference_robot.x_m - s * T_reference_robot.y_m;
    const double y_m = s * T_reference_robot.x_m + c * T_reference_robot.y_m;
    Matrix3d by_reference = Matrix3d::Identity();
    by_reference(0, 2) = -y_m;
    by_reference(1, 2) = x_m;
    const double length_m = std::max(std::abs(motion.forward_m), 1e-9);
    const double way_sigma_m = motion.forward_measured ? motion.sigma_forward_m : 0.0;
    const double turn_sigma_rad = motion.omega_measured ? motion.sigma_omega_rad : 0.0;
    const Vector3d by_way = Vector3d(x_m, y_m, 0.0) * (way_sigma_m / length_m);
    const Vector3d by_turn = Vector3d(-y_m / 2, x_m / 2, 1.0) * turn_sigma_rad;
    now_ = by_reference * reference_ * by_reference.transpose() + by_way * by_way.transpose() +
           by_turn * by_turn.transpose();
    way_variance_m2_ = reference_way_m2_ + way_sigma_m * way_sigma_m;
    turn_variance_rad2_ = reference_turn_rad2_ + turn_sigma_rad * turn_sigma_rad;
}

void PoseUncertainty::begin_cycle() {
    reference_ = now_;
    reference_way_m2_ = way_variance_m2_;
    reference_turn_rad2_ = turn_variance_rad2_;
}

Matrix3d PoseUncertainty::covariance(const Pose2& T_start_robot, const CarriedPose& carried) const {
    const Vector3d by_scale(scale * T_start_robot.x_m, scale * T_start_robot.y_m, 0.0);
    Matrix3d covariance = now_ + by_scale * by_scale.transpose();
    covariance(0, 0) += carried.sigma_m * carried.sigma_m;
    covariance(1, 1) += carried.sigma_m * carried.sigma_m;
    covariance(2, 2) += carried.sigma_rad * carried.sigma_rad;
    return covariance;
}

}  // namespace flownav::pipeline
