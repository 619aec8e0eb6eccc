#include <algorithm>
#include <cmath>
#include <ctime>

#include "flownav/io/kitti.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/math/units.h"
#include "import_files.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;

/// Finds the folder of a drive, given its name or the part of it between "drive_" and "_sync".
fs::path drive_directory(const fs::path& date_directory, const std::string& drive) {
    require_directory(date_directory);
    if (fs::is_directory(date_directory / drive)) return date_directory / drive;
    const std::string ending = "_drive_" + drive + "_sync";
    for (const auto& entry : fs::directory_iterator(date_directory)) {
        const std::string name = entry.path().filename().string();
        const bool matches = name.size() > ending.size() &&
                             name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
        if (entry.is_directory() && matches) return entry.path();
    }
    throw InputError(date_directory.string() + ": holds no drive '" + drive + "' (folder " + drive + " or *" +
                     ending + ")");
}

std::string camera_number(const fs::path& drive) {
    for (const char* number : {"00", "01", "02", "03"}) {
        if (fs::is_directory(drive / ("image_" + std::string(number)))) return number;
    }
    throw InputError(drive.string() + ": holds none of the folders image_00 .. image_03");
}

/// Parses a UTC time such as "2011-09-26 13:02:25.964389445" to seconds since the epoch.
double parse_time(const std::string& text, const fs::path& file) {
    std::tm date{};
    const char* rest = strptime(text.c_str(), "%Y-%m-%d %H:%M:%S", &date);
    if (rest == nullptr) throw InputError(file.string() + ": '" + text + "' is no time");
    const double fraction = *rest == '.' ? std::strtod(rest, nullptr) : 0.0;
    return static_cast<double>(timegm(&date)) + fraction;
}

std::vector<double> times_of(const fs::path& file, std::size_t images, double rate_hz) {
    std::vector<double> times_s;
    if (fs::exists(file)) {
        for (const std::string& line : read_lines(file)) times_s.push_back(parse_time(line, file));
    } else {
        for (std::size_t i = 0; i < images; ++i) times_s.push_back(static_cast<double>(i) / rate_hz);
    }
    return times_s;
}

/// Poses of the GPS/IMU unit in the frame of the first one, by a Mercator projection with the scale at the
/// start. Empty when there are none.
std::vector<Pose2> oxts_poses(const fs::path& directory, std::size_t count) {
    constexpr double earth_radius_m = 6378137.0;
    std::vector<Pose2> poses;
    double scale = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string number = std::to_string(i);
        const fs::path file =
            directory / (std::string(10 - std::min<std::size_t>(10, number.size()), '0') + number + ".txt");
        if (!fs::exists(file)) break;
        const auto lines = read_lines(file);
        const auto v = lines.empty() ? std::vector<double>{} : numbers_of(lines.front());
        if (v.size() < 6) throw InputError(file.string() + ": holds no latitude, longitude and angles");
        if (i == 0) scale = std::cos(v[0] * degree_rad);
        const double east_m = scale * earth_radius_m * v[1] * degree_rad;
        const double north_m = scale * earth_radius_m * std::log(std::tan((90 + v[0]) * degree_rad / 2));
        poses.push_back({east_m, north_m, v[5]});
    }
    if (poses.empty()) return poses;
    const Pose2 T_first_world = inverse(poses.front());
    for (Pose2& pose : poses) pose = compose(T_first_world, pose);
    return poses;
}

}  // namespace

KittiRaw::KittiRaw(const fs::path& date_directory, const std::string& drive, double rate_hz,
                   const CameraMount& mount) {
    const fs::path folder = drive_directory(date_directory, drive);
    const std::string number = camera_number(folder);
    const fs::path images = folder / ("image_" + number);
    images_ = list_images(images / "data");
    times_s_ = times_of(images / "timestamps.txt", images_.size(), rate_hz);
    const fs::path calibration = date_directory / "calib_cam_to_cam.txt";
    camera_ = kitti_camera(read_kitti_calibration(calibration), "P_rect_" + number, calibration, mount);
    T_start_robot_ = oxts_poses(folder / "oxts" / "data", times_s_.size());
}

}  // namespace flownav::io
