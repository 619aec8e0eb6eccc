#include "flownav/nav/odometry_watch.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "flownav/core/interpolate.h"
#include "sentence.h"

namespace flownav::nav {
namespace {

constexpr double history_s = 3.0;
constexpr double extrapolation_s = 0.1;  // fields may be newer than the odometry by this
constexpr double standing_m = 0.001;     // less between two fields is no motion
constexpr double agreed_way_m = 0.03;    // of the wheels, to confirm the flow
constexpr double agreed_turn_rad = 0.05;
constexpr double agreed_share = 0.3;

}  // namespace

void OdometryWatch::odometry(double time_s, const Pose2& T_odom_robot) {
    if (time_s <= newest_s_) return;
    if (!wheels_.empty() && jumps_.is_jump(wheels_.back().pose, T_odom_robot, time_s - newest_s_))
        forget_before(time_s);
    newest_s_ = time_s;
    wheels_.push_back({time_s, T_odom_robot});
    while (time_s - wheels_.front().time_s > history_s) wheels_.pop_front();
}

void OdometryWatch::forget_before(double time_s) {
    jumped_s_ = time_s;
    wheels_.clear();
    turns_.clear();
    ways_.clear();
    cycle_s_.reset();
}

/// After a time stamp in the future every right one would look older, and nobody would notice that none
/// comes.
void OdometryWatch::forget_future(double time_s) {
    const double latest_s = time_s + params_.ahead_s;
    if (last_ && last_->timestamp_s > latest_s) last_.reset();
    if (newest_s_ <= latest_s) return;
    forget_before(time_s);
    newest_s_ = time_s;
}

std::optional<Pose2> OdometryWatch::wheels_at(double time_s) const {
    const auto later = std::find_if(wheels_.begin(), wheels_.end(),
                                    [&](const Stamped& stamped) { return stamped.time_s >= time_s; });
    if (wheels_.size() < 2) return {};
    if (later == wheels_.begin()) {
        if (later->time_s == time_s) return later->pose;
        return {};
    }
    const bool beyond = later == wheels_.end();
    if (beyond && time_s - newest_s_ > extrapolation_s) return {};
    const auto to = beyond ? std::prev(later) : later;
    const auto from = std::prev(to);
    return interpolated(from->pose, to->pose, (time_s - from->time_s) / (to->time_s - from->time_s));
}

std::optional<Pose2> OdometryWatch::wheels_between(double from_s, double to_s) const {
    const std::optional<Pose2> from = wheels_at(from_s);
    const std::optional<Pose2> to = wheels_at(to_s);
    if (!from || !to) return {};
    return compose(inverse(*from), *to);
}

void OdometryWatch::sensed(const SensorReport& report) {
    if (last_ && report.timestamp_s <= last_->timestamp_s) return;
    if (report.status == FieldStatus::Ok) {
        compare_turn(report);
        compare_way(report);
        count_repeated(report);
    }
    const bool new_cycle = report.end_of_cycle || report.status == FieldStatus::Waiting;
    if (new_cycle) cycle_s_ = report.timestamp_s;
    last_ = report;
    for (std::deque<Pair>* pairs : {&turns_, &ways_}) {
        while (!pairs->empty() && report.timestamp_s - pairs->front().end_s > params_.window_s)
            pairs->pop_front();
    }
}

void OdometryWatch::compare_turn(const SensorReport& report) {
    if (!last_ || last_->status != FieldStatus::Ok) return;
    const std::optional<Pose2> wheels = wheels_between(last_->timestamp_s, report.timestamp_s);
    if (!wheels) return;
    const double flow_rad = report.omega_radps * (report.timestamp_s - last_->timestamp_s);
    turns_.push_back({last_->timestamp_s, report.timestamp_s, flow_rad, wheels->yaw_rad});
}

void OdometryWatch::compare_way(const SensorReport& report) {
    if (!report.v_measured || !cycle_s_) return;
    const std::optional<Pose2> wheels = wheels_between(*cycle_s_, report.timestamp_s);
    if (!wheels) return;
    const double wheels_m = std::copysign(std::hypot(wheels->x_m, wheels->y_m), wheels->x_m);
    ways_.push_back(
        {*cycle_s_, report.timestamp_s, report.v_mps * (report.timestamp_s - *cycle_s_), wheels_m});
}

void OdometryWatch::count_repeated(const SensorReport& report) {
    if (!last_) return;
    const std::optional<Pose2> wheels = wheels_between(last_->timestamp_s, report.timestamp_s);
    const double moved_m =
        wheels ? std::hypot(wheels->x_m, wheels->y_m) + std::abs(wheels->yaw_rad) * radius_m_ : 0.0;
    const bool counts = report.repeated && moved_m > standing_m;
    repeated_fields_ = counts ? repeated_fields_ + 1 : 0;
    repeated_way_m_ = counts ? repeated_way_m_ + moved_m : 0.0;
}

bool OdometryWatch::is_confirmed_since(double since_s) const {
    const auto agree = [&](const std::deque<Pair>& pairs, double enough) {
        double flow = 0.0, wheels = 0.0;
        for (const Pair& pair : pairs) {
            if (pair.begin_s < since_s) continue;
            flow += pair.flow;
            wheels += pair.wheels;
        }
        return std::abs(wheels) >= enough && std::abs(flow - wheels) <= agreed_share * std::abs(wheels);
    };
    return agree(ways_, agreed_way_m) || agree(turns_, agreed_turn_rad);
}

Fault OdometryWatch::contradiction(const std::deque<Pair>& pairs, double free, double share,
                                   const char* what) const {
    double flow = 0.0, wheels = 0.0, amount = 0.0;
    for (const Pair& pair : pairs) {
        flow += pair.flow;
        wheels += pair.wheels;
        amount += std::max(std::abs(pair.flow), std::abs(pair.wheels));
    }
    if (std::abs(flow - wheels) <= free + share * amount) return {};
    return {GuardReason::OdometryContradiction,
            sentence("over ", params_.window_s, " s the wheels tell ", wheels, what, ", the flow ", flow)};
}

Fault OdometryWatch::fault(double time_s) {
    if (newest_s_ < -1e8) return {};  // a robot without wheel odometry
    forget_future(time_s);
    if (repeated_fields_ >= params_.frozen_fields && repeated_way_m_ >= params_.frozen_way_m) {
        return {GuardReason::SensorFrozen,
                sentence("the last ", repeated_fields_, " images are alike, though the wheels moved ",
                         repeated_way_m_, " m")};
    }
    if (time_s - newest_s_ > params_.silent_s) {
        return {GuardReason::OdometryContradiction,
                sentence("no odometry of the wheels for ", time_s - newest_s_, " s")};
    }
    if (time_s - jumped_s_ < params_.hold_s) {
        return {GuardReason::OdometryContradiction,
                "the pose of the wheels jumped farther than the robot can drive"};
    }
    if (Fault fault = contradiction(turns_, params_.turn_rad, params_.turn_share, " rad")) return fault;
    return contradiction(ways_, params_.way_m, params_.way_share, " m");
}

}  // namespace flownav::nav
