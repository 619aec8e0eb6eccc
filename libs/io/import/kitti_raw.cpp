#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "flownav/io/errors.h"
#include "flownav/io/kitti.h"
#include "flownav/io/picture_file.h"
#include "flownav/math/units.h"
#include "import_files.h"
#include "kitti_calibration.h"
#include "pose_track.h"
#include "written_time.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;

bool ends_with(const std::string& text, const std::string& ending) {
    return text.size() > ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// Finds the folder of a drive, given its name or the part of it between "drive_" and "_sync" or "_extract".
fs::path drive_directory(const fs::path& date_directory, const std::string& drive) {
    require_directory(date_directory);
    if (fs::is_directory(date_directory / drive)) return date_directory / drive;
    const std::string part = "_drive_" + drive;
    for (const char* kind : {"_sync", "_extract"}) {
        for (const auto& entry : fs::directory_iterator(date_directory))
            if (entry.is_directory() && ends_with(entry.path().filename().string(), part + kind))
                return entry.path();
    }
    throw InputError(date_directory.string() + ": holds no drive '" + drive + "' (folder " + drive + ", *" +
                     part + "_sync or *" + part + "_extract)");
}

bool holds_files(const fs::path& folder) {
    return fs::is_directory(folder) && fs::directory_iterator(folder) != fs::directory_iterator();
}

std::string camera_number(const fs::path& drive) {
    for (const char* number : {"00", "01", "02", "03"}) {
        if (holds_files(drive / ("image_" + std::string(number)) / "data")) return number;
    }
    throw InputError(drive.string() + ": none of its folders image_00 .. image_03 holds images in data");
}

/// Times by number: line i + 1 belongs to number i; empty lines are lost images.
std::vector<std::optional<double>> times_of(const fs::path& file) {
    std::vector<std::optional<double>> times_s;
    for (const TextLine& line : read_text_lines(file)) {
        const auto time = parse_written_time(line.text.substr(0, line.text.find_last_not_of(" \t") + 1));
        if (!time || !time->date)
            throw InputError(file.string() + ", line " + std::to_string(line.number) + ": '" + line.text +
                             "' is no time");
        times_s.resize(line.number);
        times_s.back() = static_cast<double>(time->value);
    }
    return times_s;
}

std::vector<std::optional<double>> times_of_rate(std::size_t count, double rate_hz) {
    std::vector<std::optional<double>> times_s;
    for (std::size_t i = 0; i < count; ++i) times_s.emplace_back(static_cast<double>(i) / rate_hz);
    return times_s;
}

fs::path oxts_file(const fs::path& directory, std::size_t number) {
    const std::string digits = std::to_string(number);
    return directory / (std::string(10 - std::min<std::size_t>(10, digits.size()), '0') + digits + ".txt");
}

/// Poses of the GPS/IMU unit in the frame of the first one, by a Mercator projection with the scale at the
/// start; empty where a file is missing. No poses at all when there is no file.
std::vector<std::optional<Pose2>> oxts_poses(const fs::path& directory, std::size_t count) {
    constexpr double earth_radius_m = 6378137.0;
    std::vector<std::optional<Pose2>> poses(count);
    std::optional<double> scale;
    std::optional<Pose2> T_first_world;
    for (std::size_t i = 0; i < count; ++i) {
        const fs::path file = oxts_file(directory, i);
        if (!fs::exists(file)) continue;
        const auto lines = read_lines(file);
        const auto v = lines.empty() ? std::vector<double>{} : numbers_of(lines.front());
        if (v.size() < 6) throw InputError(file.string() + ": holds no latitude, longitude and angles");
        if (!scale) scale = std::cos(v[0] * degree_rad);
        const double east_m = *scale * earth_radius_m * v[1] * degree_rad;
        const double north_m = *scale * earth_radius_m * std::log(std::tan((90 + v[0]) * degree_rad / 2));
        const Pose2 T_world_robot{east_m, north_m, v[5]};
        if (!T_first_world) T_first_world = inverse(T_world_robot);
        poses[i] = compose(*T_first_world, T_world_robot);
    }
    if (!T_first_world) poses.clear();
    return poses;
}

/// Poses of the GPS/IMU unit at the times of images that were not taken together with it; empty without its
/// times.
std::vector<std::optional<Pose2>> poses_by_time(const fs::path& oxts,
                                                const std::vector<std::optional<double>>& times_s) {
    if (!fs::exists(oxts / "timestamps.txt")) return {};
    const auto oxts_s = times_of(oxts / "timestamps.txt");
    const auto poses = oxts_poses(oxts / "data", oxts_s.size());
    std::vector<TimedPose> timed;
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (poses[i] && oxts_s[i]) timed.push_back({*oxts_s[i], *poses[i]});
    const PoseTrack track(std::move(timed));
    std::vector<std::optional<Pose2>> at_images;
    for (const auto& time_s : times_s) at_images.push_back(time_s ? track.at(*time_s) : std::nullopt);
    return at_images;
}

/// Tells of missing files of oxts; empty when none is missing.
std::string missing_poses(const std::vector<std::optional<Pose2>>& poses, const fs::path& directory) {
    std::size_t missing = 0;
    std::size_t first = 0;
    for (std::size_t i = poses.size(); i-- > 0;) {
        if (poses[i]) continue;
        ++missing;
        first = i;
    }
    if (missing == 0) return "";
    return directory.string() + ": " + std::to_string(missing) + " of " + std::to_string(poses.size()) +
           " files are missing, the first is " + oxts_file(directory, first).filename().string() +
           "; images with these numbers have no ground truth";
}

/// Size of the first picture that can be read.
std::pair<int, int> picture_size(const std::vector<fs::path>& images) {
    for (const fs::path& image : images) {
        const cv::Mat pixels = read_picture(image, cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH);
        if (!pixels.empty()) return {pixels.cols, pixels.rows};
    }
    throw InputError("no image could be read: " + images.front().string() + ": cannot be read as a picture");
}

}  // namespace

KittiRaw::KittiRaw(const fs::path& date_directory, const std::string& drive, double rate_hz,
                   const CameraMount& mount) {
    const fs::path folder = drive_directory(date_directory, drive);
    const std::string number = camera_number(folder);
    const fs::path images = folder / ("image_" + number);
    take_images(images / "data");
    if (fs::exists(images / "timestamps.txt")) {
        times_s_ = times_of(images / "timestamps.txt");
    } else {
        times_s_ = times_of_rate(numbers(), rate_hz);
        std::ostringstream rate;
        rate << rate_hz;
        add_note(images.string() + ": has no timestamps.txt; the images have the times of their numbers at " +
                 rate.str() + " images a second (--rate)");
    }
    const auto size = picture_size(images_);
    const FoundCamera found =
        kitti_raw_camera(read_kitti_calibration(date_directory / "calib_cam_to_cam.txt"), number, size.first,
                         size.second, mount);
    camera_ = found.camera;
    if (!found.note.empty()) add_note(found.note);
    tell_missing_images();
    const fs::path oxts = folder / "oxts";
    if (ends_with(folder.filename().string(), "_extract")) {
        T_start_robot_ = poses_by_time(oxts, times_s_);
        if (T_start_robot_.empty() && holds_files(oxts / "data"))
            add_note(oxts.string() +
                     ": has no timestamps.txt; the poses of a drive that is not synchronised "
                     "cannot be used without it");
        return;
    }
    T_start_robot_ = oxts_poses(oxts / "data", times_s_.size());
    const std::string missing = missing_poses(T_start_robot_, oxts / "data");
    if (!missing.empty()) add_problem(missing);
}

}  // namespace flownav::io
