#include "flownav/pipeline/motion_history.h"

#include <algorithm>
#include <cmath>

#include "flownav/core/interpolate.h"

namespace flownav::pipeline {
namespace {

constexpr double carried_min_s = 1e-6;

}  // namespace

std::optional<MotionHistory::Entry> MotionHistory::at(double time_s) const {
    if (entries_.empty() || !(time_s >= entries_.front().timestamp_s) || time_s > entries_.back().timestamp_s)
        return std::nullopt;
    const auto is_before = [time_s](const Entry& e) { return e.timestamp_s < time_s; };
    const std::size_t later = entries_.partition_point(is_before);
    const Entry& b = entries_[later];
    if (later == 0 || b.timestamp_s == time_s) return b;
    const Entry& a = entries_[later - 1];
    const double share = (time_s - a.timestamp_s) / (b.timestamp_s - a.timestamp_s);
    const auto mean = [share](double from, double to) { return from + share * (to - from); };
    return Entry{time_s, interpolated(a.T_start_robot, b.T_start_robot, share),
                 mean(a.variance_m2, b.variance_m2), mean(a.variance_rad2, b.variance_rad2),
                 mean(a.carried_s, b.carried_s)};
}

std::optional<MotionBetween> MotionHistory::between(double from_s, double to_s) const {
    const auto from = at(from_s);
    const auto to = at(to_s);
    if (!from || !to) return std::nullopt;
    MotionBetween motion;
    motion.T_from_to = compose(inverse(from->T_start_robot), to->T_start_robot);
    motion.sigma_m = std::sqrt(std::abs(to->variance_m2 - from->variance_m2));
    motion.sigma_rad = std::sqrt(std::abs(to->variance_rad2 - from->variance_rad2));
    const bool carried = std::abs(to->carried_s - from->carried_s) > carried_min_s;
    motion.source = carried ? MotionSource::Prediction : MotionSource::Flow;
    return motion;
}

}  // namespace flownav::pipeline
