#include "sensor_yaml.h"

#include <opencv2/core.hpp>

#include "flownav/io/errors.h"
#include "import_files.h"

namespace flownav::io {
namespace {

std::vector<double> numbers_of(const cv::FileNode& node) {
    std::vector<double> numbers;
    if (!node.isSeq()) return numbers;
    for (const auto& entry : node)
        if (entry.isReal() || entry.isInt()) numbers.push_back(entry.real());
    return numbers;
}

std::optional<std::array<double, 4>> four_numbers(const cv::FileNode& node) {
    const auto numbers = numbers_of(node);
    if (numbers.size() != 4) return std::nullopt;
    return std::array<double, 4>{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::optional<Eigen::Isometry3d> pose_of(const cv::FileNode& node) {
    const auto numbers = numbers_of(node);
    if (numbers.size() != 16) return std::nullopt;
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 12; ++i) T.matrix()(i / 4, i % 4) = numbers[static_cast<std::size_t>(i)];
    return T;
}

}  // namespace

SensorYaml read_sensor_yaml(const std::filesystem::path& file) {
    std::string text = "%YAML:1.0\n---\n";
    for (const std::string& line : read_lines(file))
        if (line.rfind("%YAML", 0) != 0 && line.rfind("---", 0) != 0) text += line + "\n";
    SensorYaml sensor;
    try {
        const cv::FileStorage yaml(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
        sensor.T_body_camera = pose_of(yaml["T_BS"]["data"]);
        sensor.intrinsics = four_numbers(yaml["intrinsics"]);
        const auto resolution = numbers_of(yaml["resolution"]);
        if (resolution.size() == 2) {
            sensor.width_px = static_cast<int>(resolution[0]);
            sensor.height_px = static_cast<int>(resolution[1]);
        }
        const cv::FileNode model = yaml["distortion_model"];
        if (model.isString() && (model.string() == "radial-tangential" || model.string() == "radtan"))
            sensor.distortion = four_numbers(yaml["distortion_coefficients"]);
    } catch (const cv::Exception&) {
        throw InputError(file.string() + ": cannot be read as YAML; move it away to go without it");
    }
    return sensor;
}

bool fill_open_keys(const SensorYaml& sensor, config::CameraConfig& camera) {
    if (!sensor.intrinsics || camera.fx_px || camera.fy_px || camera.cx_px || camera.cy_px) return false;
    const auto& k = *sensor.intrinsics;
    camera.fx_px = k[0];
    camera.fy_px = k[1];
    camera.cx_px = k[2];
    camera.cy_px = k[3];
    if (!camera.distortion && sensor.distortion) {
        const auto& d = *sensor.distortion;
        camera.distortion = LensCoefficients{d[0], d[1], d[2], d[3], 0.0};
    }
    return true;
}

}  // namespace flownav::io
