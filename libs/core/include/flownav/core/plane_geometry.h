#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "flownav/core/camera_model.h"

namespace flownav {

/// z component of the cross product of two plane vectors.
inline double cross(const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return p.x() * q.y() - p.y() * q.x();
}

/// Displacement of the CAMERA on the ground, (forward, leftward) in metres, in the robot's frame half-way
/// through a motion of `forward_m` and `omega_rad`. The camera may sit off the axis. `chord_rad`: direction
/// of the robot's chord in that frame, see EgoMotion.
inline Eigen::Vector2d camera_travel(const CameraMount& mount, double forward_m, double omega_rad,
                                     double chord_rad = 0.0) {
    return {forward_m * std::cos(chord_rad) - omega_rad * mount.left_m,
            forward_m * std::sin(chord_rad) + omega_rad * mount.forward_m};
}

/// The fields e, h and p of Eq. (3) at a point `at` = (x, y) of the normalised plane. The level camera has
/// the pitch rho, a = cos rho, b = sin rho, and stands H metres above the ground. Flow is f = (S/Z) e + omega
/// h + pitch p.
struct PlaneGeometry {
    double a = 1.0;
    double b = 0.0;
    double per_height = 0.0;  ///< 1/H

    PlaneGeometry() = default;
    explicit PlaneGeometry(const CameraMount& mount)
        : a(std::cos(mount.pitch_rad)), b(std::sin(mount.pitch_rad)), per_height(1.0 / mount.height_m) {}

    /// a y + b, the ratio of H to the ground's depth: 0 on the horizon, negative above it.
    double below_horizon(const Eigen::Vector2d& at) const { return a * at.y() + b; }

    /// Eq. (8) as 1/Z of the ground, in 1/m: 0 on the horizon and above.
    double ground_inverse_depth(const Eigen::Vector2d& at) const {
        return std::max(0.0, below_horizon(at)) * per_height;
    }

    /// Point of the normalised plane that shows the floor `forward_m` ahead of the camera and `right_m` to
    /// its right; empty when that floor lies behind the camera.
    std::optional<Eigen::Vector2d> floor_at(double forward_m, double right_m) const {
        const double forward = forward_m * per_height;
        const double depth = a * forward + b;
        if (!(depth > 0.0)) return std::nullopt;
        return Eigen::Vector2d(right_m * per_height, a - b * forward) / depth;
    }

    /// Flow times depth of a camera that moves by `travel` = (forward, leftward). For pure forward travel
    /// this is e of Eq. (3); the leftward part is the swing of a camera off the axis.
    Eigen::Vector2d e(const Eigen::Vector2d& at, const Eigen::Vector2d& travel = {1.0, 0.0}) const {
        return {travel.x() * a * at.x() + travel.y(), travel.x() * below_horizon(at)};
    }

    /// Flow of a unit turn to the left.
    Eigen::Vector2d h(const Eigen::Vector2d& at) const {
        return {a * (at.x() * at.x() + 1.0) - b * at.y(), a * at.x() * at.y() + b * at.x()};
    }

    /// Flow of a unit pitch that raises the view.
    static Eigen::Vector2d p(const Eigen::Vector2d& at) { return {at.x() * at.y(), at.y() * at.y() + 1.0}; }
};

/// Standard deviation of e.dot(d) when the components x and y of d have the deviations `sigma`.
inline double deviation_of_dot(const Eigen::Vector2d& e, const Eigen::Vector2d& sigma) {
    return e.cwiseProduct(sigma).norm();
}

/// Standard deviation of cross(e, d) when the components x and y of d have the deviations `sigma`.
inline double deviation_of_cross(const Eigen::Vector2d& e, const Eigen::Vector2d& sigma) {
    return Eigen::Vector2d(e.y() * sigma.x(), e.x() * sigma.y()).norm();
}

/// Size of one pixel on the normalised plane, in x and y. As `sigma` of the deviations above it gives one
/// pixel along or across e, the unit of tau and lambda.
inline Eigen::Vector2d one_pixel(const CameraModel& camera) {
    return {1.0 / camera.fx_px, 1.0 / camera.fy_px};
}

/// True in the ground window, where the floor right in front of the robot is expected to be free and its flow
/// gives the speed: the lower third of the image without a sixth of the width on either side.
inline bool in_ground_window(const Eigen::Vector2d& at_px, const CameraModel& camera) {
    return at_px.y() > camera.height_px * 2.0 / 3.0 && at_px.x() > camera.width_px / 6.0 &&
           at_px.x() < camera.width_px * 5.0 / 6.0;
}

}  // namespace flownav
