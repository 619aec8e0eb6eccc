#include <mrpt/math/CMatrixFixed.h>

#include "flownav/io/camera_conversion.h"
#include "flownav/io/kitti.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/io/time_unit.h"
#include "import_files.h"
#include "kitti_calibration.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;
using mrpt::poses::CPose3D;

CPose3D pose_of(const std::vector<double>& m, const std::string& place) {
    if (m.size() != 12) throw InputError(place + ": is no pose (12 numbers)");
    mrpt::math::CMatrixDouble44 T = mrpt::math::CMatrixDouble44::Identity();
    for (int i = 0; i < 12; ++i) T(i / 4, i % 4) = m[static_cast<std::size_t>(i)];
    return CPose3D(T);
}

/// Reads poses of the camera in the frame of its first image; returns poses of the robot's axis, on the
/// ground, in the frame of the first.
std::vector<std::optional<Pose2>> axis_poses(const fs::path& file, const CameraMount& mount) {
    const CPose3D T_axis_camera = camera_pose(mount);
    const CPose3D T_camera_axis = -T_axis_camera;
    std::vector<std::optional<Pose2>> poses;
    for (const std::string& line : read_lines(file)) {
        const std::string place = file.string() + ", line " + std::to_string(poses.size() + 1);
        const CPose3D T_first_axis = T_axis_camera + pose_of(numbers_of(line), place) + T_camera_axis;
        poses.push_back(Pose2{T_first_axis.x(), T_first_axis.y(), T_first_axis.yaw()});
    }
    return poses;
}

std::vector<std::optional<double>> times_of(const fs::path& file) {
    std::vector<std::optional<double>> times_s;
    for (const std::string& line : read_lines(file)) {
        const auto numbers = numbers_of(line);
        if (numbers.size() != 1 || !(numbers[0] >= 0) || numbers[0] > latest_time_s)
            throw InputError(file.string() + ": '" + line + "' is no time");
        times_s.emplace_back(numbers[0]);
    }
    return times_s;
}

/// Number of the first camera that has images.
std::string camera_number(const fs::path& sequence) {
    for (const char* number : {"0", "1", "2", "3"})
        if (fs::is_directory(sequence / ("image_" + std::string(number)))) return number;
    return "0";
}

}  // namespace

KittiOdometry::KittiOdometry(const fs::path& directory, const std::string& sequence,
                             const CameraMount& mount) {
    require_directory(directory);
    const fs::path folder = directory / "sequences" / sequence;
    require_directory(folder);
    const std::string number = camera_number(folder);
    take_images(folder / ("image_" + number));
    if (number != "0") add_note(folder.string() + ": has no image_0; image_" + number + " is taken");
    times_s_ = times_of(folder / "times.txt");
    camera_ = kitti_camera(read_kitti_calibration(folder / "calib.txt"), "P" + number, mount);
    const fs::path poses = directory / "poses" / (sequence + ".txt");
    if (fs::exists(poses)) T_start_robot_ = axis_poses(poses, mount);
    tell_missing_images();
    if (!T_start_robot_.empty() && T_start_robot_.size() != times_s_.size())
        add_note(poses.string() + ": holds " + std::to_string(T_start_robot_.size()) + " poses for " +
                 std::to_string(times_s_.size()) + " times; pose i is that of image i");
}

}  // namespace flownav::io
