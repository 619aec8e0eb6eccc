#include "pose_track.h"

#include <algorithm>
#include <cmath>

#include "data_table.h"
#include "flownav/io/camera_conversion.h"
#include "flownav/io/errors.h"
#include "written_time.h"

namespace flownav::io {
namespace {

/// Numbers of a row, which may hold more than `count`. Throws InputError when it holds fewer.
std::vector<long double> numbers_in(const DataTable& table, const TableRow& row, std::size_t count) {
    std::vector<long double> numbers;
    for (const std::string& cell : row.cells) {
        const auto number = parse_written_time(cell);
        if (!number) break;
        numbers.push_back(number->value);
    }
    if (numbers.size() >= count) return numbers;
    throw InputError(table.file.string() + ", line " + std::to_string(row.line) + ": is no pose (" +
                     std::to_string(count) + " numbers)");
}

Eigen::Isometry3d pose_of(const std::vector<long double>& numbers, const Eigen::Quaterniond& q) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = q.normalized().toRotationMatrix();
    for (int i = 0; i < 3; ++i)
        T.translation()(i) = static_cast<double>(numbers[static_cast<std::size_t>(i) + 1]);
    return T;
}

/// Quaternion with w at numbers[w] and x, y, z from numbers[x] on.
Eigen::Quaterniond quaternion(const std::vector<long double>& numbers, std::size_t w, std::size_t x) {
    const auto at = [&](std::size_t i) { return static_cast<double>(numbers[i]); };
    return {at(w), at(x), at(x + 1), at(x + 2)};
}

Pose2 on_the_ground(const Eigen::Isometry3d& T) {
    return {T.translation().x(), T.translation().y(), std::atan2(T.linear()(1, 0), T.linear()(0, 0))};
}

Pose2 between(const TimedPose& a, const TimedPose& b, double timestamp_s) {
    const double share = (timestamp_s - a.timestamp_s) / (b.timestamp_s - a.timestamp_s);
    const double turn = wrap_angle(b.T_world_robot.yaw_rad - a.T_world_robot.yaw_rad);
    return {a.T_world_robot.x_m + share * (b.T_world_robot.x_m - a.T_world_robot.x_m),
            a.T_world_robot.y_m + share * (b.T_world_robot.y_m - a.T_world_robot.y_m),
            a.T_world_robot.yaw_rad + share * turn};
}

}  // namespace

std::optional<Pose2> PoseTrack::at(double timestamp_s) const {
    constexpr double gap_max_s = 0.25;
    const auto later = std::lower_bound(poses_.begin(), poses_.end(), timestamp_s,
                                        [](const TimedPose& pose, double t) { return pose.timestamp_s < t; });
    if (later == poses_.end()) return std::nullopt;
    if (later->timestamp_s == timestamp_s) return later->T_world_robot;
    if (later == poses_.begin()) return std::nullopt;
    const auto earlier = std::prev(later);
    if (later->timestamp_s - earlier->timestamp_s > gap_max_s) return std::nullopt;
    return between(*earlier, *later, timestamp_s);
}

std::vector<SpacePose> read_tum_poses(const std::filesystem::path& file) {
    const DataTable table = read_table(file);
    std::vector<SpacePose> poses;
    for (const TableRow& row : table.rows) {
        const auto n = numbers_in(table, row, 8);
        poses.push_back({static_cast<double>(n[0]), pose_of(n, quaternion(n, 7, 4))});
    }
    return poses;
}

std::vector<SpacePose> read_euroc_poses(const std::filesystem::path& file) {
    const DataTable table = read_table(file);
    std::vector<SpacePose> poses;
    for (const TableRow& row : table.rows) {
        const auto n = numbers_in(table, row, 8);
        poses.push_back({static_cast<double>(n[0] / 1e9L), pose_of(n, quaternion(n, 4, 5))});
    }
    return poses;
}

PoseTrack robot_track(const std::vector<SpacePose>& poses, const Eigen::Isometry3d& T_body_camera,
                      const CameraMount& mount) {
    const Eigen::Isometry3d T_robot_camera(
        camera_pose(mount).getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>().asEigen());
    const Eigen::Isometry3d T_body_robot = T_body_camera * T_robot_camera.inverse();
    std::vector<TimedPose> track;
    for (const SpacePose& pose : poses)
        track.push_back({pose.timestamp_s, on_the_ground(pose.T_world_body * T_body_robot)});
    const auto earlier = [](const TimedPose& a, const TimedPose& b) { return a.timestamp_s < b.timestamp_s; };
    std::stable_sort(track.begin(), track.end(), earlier);
    return PoseTrack(std::move(track));
}

}  // namespace flownav::io
