#include "flownav/motion/gyro_track.h"

#include <algorithm>
#include <cmath>

namespace flownav::motion {
namespace {

// Standard errors of a small gyro on a robot that shakes.
constexpr double noise_rad_per_sqrt_s = 0.002;
constexpr double turn_share = 0.02;
constexpr double late_s = 0.004;  // of the readings against the images
// Learning the bias.
constexpr double drift_radps_per_sqrt_s = 0.0005;
constexpr double lesson_sigma_min_radps = 0.002;
constexpr double outlier = 4.0;  // standard deviations

}  // namespace

void GyroTrack::note(const GyroRate& reading) {
    if (!std::isfinite(reading.timestamp_s) || !std::isfinite(reading.omega_radps)) return;
    Node node{reading.timestamp_s, reading.omega_radps, 0.0, reading.timestamp_s};
    if (!nodes_.empty()) {
        const Node& last = nodes_.back();
        const double dt_s = node.timestamp_s - last.timestamp_s;
        if (dt_s <= 0.0) return;
        node.heading_rad = last.heading_rad + 0.5 * (last.omega_radps + node.omega_radps) * dt_s;
        if (dt_s <= pause_max_s) node.begun_s = last.begun_s;
    }
    nodes_.push(node);
}

std::optional<GyroTrack::Heading> GyroTrack::at(double time_s) const {
    if (nodes_.empty()) return std::nullopt;
    const auto is_before = [time_s](const Node& n) { return n.timestamp_s < time_s; };
    const std::size_t later = nodes_.partition_point(is_before);
    if (later == 0 || later == nodes_.size()) {
        const Node& end = later == 0 ? nodes_.front() : nodes_.back();
        const double outside_s = time_s - end.timestamp_s;
        if (std::abs(outside_s) > extrapolation_s) return std::nullopt;
        return Heading{end.heading_rad + end.omega_radps * outside_s, end.omega_radps};
    }
    const Node& a = nodes_[later - 1];
    const Node& b = nodes_[later];
    const double since_s = time_s - a.timestamp_s;
    const double slope_radps2 = (b.omega_radps - a.omega_radps) / (b.timestamp_s - a.timestamp_s);
    return Heading{a.heading_rad + (a.omega_radps + 0.5 * slope_radps2 * since_s) * since_s,
                   a.omega_radps + slope_radps2 * since_s};
}

std::optional<GyroTurn> GyroTrack::between(double from_s, double to_s) const {
    const auto from = at(from_s);
    const auto to = at(to_s);
    if (!from || !to || !(from_s <= to_s)) return std::nullopt;
    const auto is_before = [to_s](const Node& n) { return n.timestamp_s < to_s; };
    const Node& end = nodes_[std::min(nodes_.partition_point(is_before), nodes_.size() - 1)];
    if (end.begun_s - extrapolation_s > from_s) return std::nullopt;
    const double dt_s = to_s - from_s;
    GyroTurn turn;
    turn.omega_rad = to->heading_rad - from->heading_rad - bias_radps_ * dt_s;
    const double scale_rad = turn_share * turn.omega_rad;
    const double noise_rad = noise_rad_per_sqrt_s * std::sqrt(dt_s);
    const double late_rad = late_s * (to->omega_radps - from->omega_radps);
    const double bias_rad = std::sqrt(bias_variance_) * dt_s;
    turn.sigma_rad = std::hypot(std::hypot(scale_rad, noise_rad), std::hypot(late_rad, bias_rad));
    return turn;
}

void GyroTrack::learn_bias(double from_s, double to_s, double omega_rad, double sigma_rad) {
    const auto told = between(from_s, to_s);
    const double dt_s = to_s - from_s;
    if (!told || dt_s <= 0.0) return;
    if (learnt_s_ > 0.0 && to_s > learnt_s_)
        bias_variance_ += drift_radps_per_sqrt_s * drift_radps_per_sqrt_s * (to_s - learnt_s_);
    learnt_s_ = to_s;
    const double error_radps = (told->omega_rad - omega_rad) / dt_s;  // of the bias so far
    // What belongs to the scale or to the noise teaches nothing about the bias.
    const double without_bias_rad =
        std::sqrt(std::max(0.0, told->sigma_rad * told->sigma_rad - bias_variance_ * dt_s * dt_s));
    const double sigma_radps =
        std::max(lesson_sigma_min_radps, std::hypot(sigma_rad, without_bias_rad) / dt_s);
    const double variance = bias_variance_ + sigma_radps * sigma_radps;
    if (std::abs(error_radps) > outlier * std::sqrt(variance)) return;
    const double gain = bias_variance_ / variance;
    bias_radps_ += gain * error_radps;
    bias_variance_ *= 1.0 - gain;
}

}  // namespace flownav::motion
