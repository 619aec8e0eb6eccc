#include "kitti_lidar.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace flownav::fidelity {
namespace {

namespace fs = std::filesystem;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Reads the `count` numbers after "KEY:" from a KITTI file.
std::vector<double> numbers_of(const fs::path& file, const std::string& key, std::size_t count) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (line.rfind(key + ':', 0) != 0) continue;
        std::istringstream text(line.substr(key.size() + 1));
        std::vector<double> numbers;
        for (double number = 0.0; text >> number;) numbers.push_back(number);
        if (numbers.size() == count) return numbers;
    }
    throw std::runtime_error(file.string() + ": has no " + key + " of " + std::to_string(count) + " numbers");
}

Matrix3d matrix_of(const std::vector<double>& numbers) {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
}

/// Transform from the lidar to the rectified camera 02.
Eigen::Isometry3d camera_from_lidar(const fs::path& date_folder) {
    const fs::path lidar = date_folder / "calib_velo_to_cam.txt";
    const fs::path cameras = date_folder / "calib_cam_to_cam.txt";
    const std::vector<double> t = numbers_of(lidar, "T", 3);
    const std::vector<double> p = numbers_of(cameras, "P_rect_02", 12);
    Eigen::Isometry3d T_camera_0_lidar = Eigen::Isometry3d::Identity();
    T_camera_0_lidar.linear() = matrix_of(numbers_of(lidar, "R", 9));
    T_camera_0_lidar.translation() = Vector3d(t[0], t[1], t[2]);
    Eigen::Isometry3d rectification = Eigen::Isometry3d::Identity();
    rectification.linear() = matrix_of(numbers_of(cameras, "R_rect_00", 9));
    // P = K [I | t]
    rectification.translation() = Vector3d((p[3] - p[2] * p[11]) / p[0], (p[7] - p[6] * p[11]) / p[5], p[11]);
    return rectification * T_camera_0_lidar;
}

}  // namespace

Eigen::Isometry3d robot_from_level(const CameraMount& mount) {
    const double a = std::cos(mount.pitch_rad);
    const double b = std::sin(mount.pitch_rad);
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() << 0, -b, a, -1, 0, 0, 0, -a, -b;
    T.translation() = Vector3d(mount.forward_m, mount.left_m, mount.height_m);
    return T;
}

Eigen::Vector2d project(const RayMapper& mapper, const Vector3d& point_m) {
    const Vector3d level_m = robot_from_level(mapper.camera().mount).inverse() * point_m;
    return mapper.pixel(level_m.head<2>() / level_m.z());
}

KittiLidar::KittiLidar(const fs::path& date_folder, const fs::path& drive_folder, const CameraMount& mount)
    : folder_(drive_folder / "velodyne_points" / "data") {
    if (!fs::is_directory(folder_)) folder_ = drive_folder / "velodyne_points";
    Eigen::Isometry3d T_level_camera = Eigen::Isometry3d::Identity();
    T_level_camera.linear() = level_rotation(mount);
    T_robot_lidar_ = robot_from_level(mount) * T_level_camera * camera_from_lidar(date_folder);
}

std::vector<Vector3d> KittiLidar::scan(int number) const {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%010d.bin", number);
    std::ifstream in(folder_ / name.data(), std::ios::binary);
    std::vector<Vector3d> points_m;
    std::array<float, 4> record{};  // x, y, z, reflectance
    while (in.read(reinterpret_cast<char*>(record.data()), sizeof record))
        points_m.push_back(T_robot_lidar_ * Vector3d(record[0], record[1], record[2]));
    return points_m;
}

}  // namespace flownav::fidelity
