#include "flownav/nav/pose_fusion.h"

namespace flownav::nav {
namespace {

constexpr double memory_s = 2.0;
constexpr double gap_max_s = 0.5;  // between fields; across longer ones the wheels tell the way
constexpr double jump_slack_m = 0.05;
constexpr double jump_slack_rad = 0.1;

/// Between two poses, on the straight line.
Pose2 between(const Pose2& a, const Pose2& b, double share) {
    return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m),
            wrap_angle(a.yaw_rad + share * wrap_angle(b.yaw_rad - a.yaw_rad))};
}

}  // namespace

PoseFusion::PoseFusion(const RobotModel& robot, const Pose2& start)
    : jumps_(robot, jump_slack_m, jump_slack_rad), T_map_odom_(start) {}

void PoseFusion::odometry(double time_s, const Pose2& T_odom_robot) {
    if (!T_wheels_odom_) T_wheels_odom_ = inverse(T_odom_robot);
    Stamped next{time_s, compose(*T_wheels_odom_, T_odom_robot)};
    if (!wheels_.empty() && jumps_.is_jump(wheels_.back().pose, next.pose, time_s - wheels_.back().time_s)) {
        // The wheels go on from where they were.
        T_wheels_odom_ = compose(wheels_.back().pose, inverse(T_odom_robot));
        next.pose = wheels_.back().pose;
    }
    wheels_.push_back(next);
    while (time_s - wheels_.front().time_s > memory_s) wheels_.pop_front();
}

void PoseFusion::flow(double time_s, const std::optional<Pose2>& T_start_robot) {
    const bool goes_on = flow_ && time_s - flow_->time_s < gap_max_s;
    if (goes_on && T_start_robot && !wheels_.empty()) {
        // From one field to the next as the flow saw it, instead of as the wheels did.
        const Pose2 moved = compose(inverse(flow_->pose), *T_start_robot);
        const Pose2 T_map_robot = compose(at(flow_->time_s), moved);
        T_map_odom_ = compose(T_map_robot, inverse(wheels_at(time_s)));
    }
    flow_.reset();
    if (T_start_robot) flow_ = Stamped{time_s, *T_start_robot};
}

Pose2 PoseFusion::now() const {
    return wheels_.empty() ? T_map_odom_ : compose(T_map_odom_, wheels_.back().pose);
}

Pose2 PoseFusion::at(double time_s) const {
    return compose(T_map_odom_, wheels_at(time_s));
}

Pose2 PoseFusion::wheels_at(double time_s) const {
    if (wheels_.empty()) return {};
    if (time_s <= wheels_.front().time_s) return wheels_.front().pose;
    for (std::size_t i = wheels_.size() - 1; i > 0; --i) {
        const Stamped& a = wheels_[i - 1];
        const Stamped& b = wheels_[i];
        if (time_s >= b.time_s) return b.pose;
        if (time_s >= a.time_s) return between(a.pose, b.pose, (time_s - a.time_s) / (b.time_s - a.time_s));
    }
    return wheels_.front().pose;
}

}  // namespace flownav::nav
