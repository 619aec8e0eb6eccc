#include "flownav/evaluation/pose_track.h"

#include <mrpt/math/slerp.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>

namespace flownav::evaluation {

namespace {

bool earlier(const TimedPose& a, const TimedPose& b) {
    return a.timestamp_s < b.timestamp_s;
}

mrpt::math::TPose3D between(const TimedPose& a, const TimedPose& b, double timestamp_s) {
    const double share = (timestamp_s - a.timestamp_s) / (b.timestamp_s - a.timestamp_s);
    mrpt::math::TPose3D pose;
    mrpt::math::slerp(a.pose, b.pose, share, pose);
    return pose;
}

}  // namespace

void PoseTrack::add(double timestamp_s, const mrpt::math::TPose3D& pose) {
    samples_.push_back({timestamp_s, pose});
}

void PoseTrack::finish() {
    std::stable_sort(samples_.begin(), samples_.end(), earlier);
    const auto same_time = [](const TimedPose& a, const TimedPose& b) {
        return a.timestamp_s == b.timestamp_s;
    };
    samples_.erase(std::unique(samples_.begin(), samples_.end(), same_time), samples_.end());
}

std::optional<mrpt::math::TPose3D> PoseTrack::at(double timestamp_s) const {
    const auto next = std::lower_bound(samples_.begin(), samples_.end(), TimedPose{timestamp_s, {}}, earlier);
    if (next == samples_.end()) return std::nullopt;
    if (next->timestamp_s == timestamp_s) return next->pose;
    if (next == samples_.begin()) return std::nullopt;
    return between(*(next - 1), *next, timestamp_s);
}

std::optional<Pose2> PoseTrack::ground_at(double timestamp_s) const {
    const auto pose = at(timestamp_s);
    if (!pose) return std::nullopt;
    return Pose2{pose->x, pose->y, pose->yaw};
}

std::vector<TimedPose> PoseTrack::aligned(double start_s) const {
    auto first = std::lower_bound(samples_.begin(), samples_.end(), TimedPose{start_s, {}}, earlier);
    if (first == samples_.end()) return {};
    TimedPose origin = *first;
    if (const auto pose = at(start_s)) origin = {start_s, *pose};
    std::vector<TimedPose> result = {{origin.timestamp_s, {}}};
    if (first->timestamp_s == origin.timestamp_s) ++first;
    const mrpt::poses::CPose3D T_world_start(origin.pose);
    for (auto sample = first; sample != samples_.end(); ++sample) {
        const mrpt::poses::CPose3D T_start_robot = mrpt::poses::CPose3D(sample->pose) - T_world_start;
        result.push_back({sample->timestamp_s, T_start_robot.asTPose()});
    }
    return result;
}

}  // namespace flownav::evaluation
