#include "import_files.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "flownav/io/picture_file.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;

bool is_image(const fs::path& file) {
    static constexpr const char* endings[] = {".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".tif", ".tiff"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(std::begin(endings), std::end(endings), ending) != std::end(endings);
}

std::size_t end_of_digits(const std::string& text, std::size_t begin) {
    while (begin < text.size() && std::isdigit(static_cast<unsigned char>(text[begin])) != 0) ++begin;
    return begin;
}

/// Compares runs of digits as numbers: img9 comes before img10.
bool natural_less(const std::string& a, const std::string& b) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        const std::size_t i_end = end_of_digits(a, i);
        const std::size_t j_end = end_of_digits(b, j);
        if (i_end > i && j_end > j) {
            while (i < i_end && a[i] == '0') ++i;
            while (j < j_end && b[j] == '0') ++j;
            if (i_end - i != j_end - j) return i_end - i < j_end - j;
            const int order = a.compare(i, i_end - i, b, j, j_end - j);
            if (order != 0) return order < 0;
            i = i_end;
            j = j_end;
        } else {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i;
            ++j;
        }
    }
    return a.size() - i < b.size() - j || (a.size() - i == b.size() - j && a < b);
}

}  // namespace

void require_directory(const fs::path& directory) {
    if (!fs::exists(directory)) throw InputError(directory.string() + ": no such folder");
    if (!fs::is_directory(directory)) throw InputError(directory.string() + ": is not a folder");
}

std::vector<fs::path> list_images(const fs::path& directory) {
    require_directory(directory);
    std::vector<fs::path> images;
    for (const auto& entry : fs::directory_iterator(directory)) {
        if (entry.is_regular_file() && is_image(entry.path())) images.push_back(entry.path());
    }
    if (images.empty()) {
        throw InputError(directory.string() + ": holds no images (png, jpg, bmp, pgm, tif)");
    }
    std::sort(images.begin(), images.end(), [](const fs::path& a, const fs::path& b) {
        return natural_less(a.filename().string(), b.filename().string());
    });
    return images;
}

std::optional<Field> load_grey(const fs::path& file) {
    const auto pixels = std::make_shared<cv::Mat>(read_picture(file, cv::IMREAD_GRAYSCALE));
    if (pixels->empty()) return std::nullopt;
    Field field;
    field.image = {pixels->data, pixels->cols, pixels->rows, static_cast<std::ptrdiff_t>(pixels->step)};
    field.owner = pixels;
    return field;
}

std::vector<std::string> read_lines(const fs::path& file) {
    std::ifstream stream(file);
    if (!stream || fs::is_directory(file)) throw InputError(file.string() + ": cannot be read");
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
    }
    return lines;
}

std::vector<double> numbers_of(const std::string& line) {
    std::string text = line;
    for (char& c : text) {
        if (c == ',' || c == ';' || c == '\r') c = ' ';
    }
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (std::string word; stream >> word;) {
        char* end = nullptr;
        numbers.push_back(std::strtod(word.c_str(), &end));
        if (*end != '\0' || !std::isfinite(numbers.back())) return {};
    }
    return numbers;
}

std::map<std::string, std::vector<double>> read_kitti_calibration(const fs::path& file) {
    std::map<std::string, std::vector<double>> calibration;
    for (const std::string& line : read_lines(file)) {
        const auto colon = line.find(':');
        if (colon == std::string::npos) continue;
        auto numbers = numbers_of(line.substr(colon + 1));
        if (!numbers.empty()) calibration[line.substr(0, colon)] = std::move(numbers);
    }
    return calibration;
}

CameraModel kitti_camera(const std::map<std::string, std::vector<double>>& calibration,
                         const std::string& key, const fs::path& file, const CameraMount& mount) {
    const auto found = calibration.find(key);
    if (found == calibration.end() || found->second.size() != 12 || !(found->second[0] > 0)) {
        throw InputError(file.string() + ": holds no projection matrix " + key + " (12 numbers)");
    }
    const std::vector<double>& P = found->second;
    CameraModel camera;
    camera.fx_px = P[0];
    camera.fy_px = P[5];
    camera.cx_px = P[2];
    camera.cy_px = P[6];
    camera.mount = mount;
    camera.mount.left_m += P[3] / P[0];
    return camera;
}

}  // namespace flownav::io
