#include "path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "flownav/math/units.h"

namespace flownav::testing {
namespace {

/// Share of the full turn rate, > 0 to the left: turns to the left and right of 1.5 s between straight pieces
/// of 1 s, entered within 0.3 s.
double turning(double time_s) {
    constexpr double piece_s = 2.5;
    constexpr double ramp_s = 0.3;
    const double piece = std::floor(time_s / piece_s);
    const double in_turn_s = time_s - piece * piece_s - 1.0;
    const double left_s = 1.5 - in_turn_s;
    const double share = std::clamp(std::min(in_turn_s, left_s) / ramp_s, 0.0, 1.0);
    return std::fmod(piece, 2.0) < 1.0 ? share : -share;
}

/// Sides of the loop and, between them, quarter circles to the left.
constexpr std::array<double, 2> loop_sides_m = {3.5, 1.5};
constexpr double loop_radius_m = 1.0;

double loop_curvature_per_m(double way_m) {
    constexpr double quarter_m = loop_radius_m * M_PI / 2.0;
    for (std::size_t side = 0; side < 4; ++side) {
        way_m -= loop_sides_m.at(side % 2);
        if (way_m < 0.0) return 0.0;
        way_m -= quarter_m;
        if (way_m < 0.0) return 1.0 / loop_radius_m;
    }
    return 0.0;
}

/// Turn rate of the robot.
double omega_radps(const SceneOptions& options, double time_s) {
    switch (options.kind) {
        case SceneKind::SCurve:
            return options.turn_radps * std::cos(2.0 * M_PI * time_s / 4.8 + 0.3);
        case SceneKind::Turns:
            return options.turn_radps * turning(time_s);
        case SceneKind::Corridor:
            return 6.0 * degree_rad * std::cos(2.0 * M_PI * time_s / 4.0);
        case SceneKind::Loop:
            return options.speed_mps * loop_curvature_per_m(options.speed_mps * time_s);
        default:
            return 0.0;
    }
}

/// Speed of the robot. StopAndGo: 1.6 s of driving and 0.8 s of rest, with ramps of 0.3 s.
double speed_mps(const SceneOptions& options, double time_s) {
    if (options.kind != SceneKind::StopAndGo) return options.speed_mps;
    constexpr double ramp_s = 0.3;
    const double in_period_s = std::fmod(time_s, 2.4);
    return options.speed_mps * std::clamp(std::min(in_period_s, 1.6 - in_period_s) / ramp_s, 0.0, 1.0);
}

double rounded(double value) {
    return std::round(value * 1e7) / 1e7;
}

}  // namespace

std::vector<Pose2> make_path(const SceneOptions& options) {
    constexpr int steps = 20;
    const double step_s = 1.0 / options.rate_hz / steps;
    std::vector<Pose2> poses;
    Pose2 pose;
    for (int i = 0; i < options.images; ++i) {
        poses.push_back({rounded(pose.x_m), rounded(pose.y_m), rounded(pose.yaw_rad)});
        for (int k = 0; k < steps; ++k) {
            const double time_s = i / options.rate_hz + (k + 0.5) * step_s;
            const double turn_rad = omega_radps(options, time_s) * step_s;
            pose = compose(pose, along_arc(turn_rad, speed_mps(options, time_s) * step_s));
        }
    }
    return poses;
}

}  // namespace flownav::testing
