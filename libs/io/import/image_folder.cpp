#include "flownav/io/image_folder.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include "flownav/io/camera_conversion.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/math/units.h"
#include "import_files.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;

/// Index of the first column with one of these names; empty when there is none.
std::optional<std::size_t> column_of(const std::string& header, const std::vector<std::string>& names) {
    std::string words = header;
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c == ',' || c == ';' || c == '#'; }, ' ');
    std::istringstream stream(words);
    std::size_t column = 0;
    for (std::string word; stream >> word; ++column)
        if (std::find(names.begin(), names.end(), word) != names.end()) return column;
    return std::nullopt;
}

/// Index of the column with the times. Sets `header` when the first line holds the names of the columns.
/// Throws InputError when no name is a known one.
std::size_t time_column(const std::string& first_line, const fs::path& file, bool& header) {
    header = numbers_of(first_line).empty();
    if (!header) return 0;
    const auto column = column_of(first_line, {"timestamp_s", "timestamp", "time_s", "time"});
    if (column) return *column;
    throw InputError(
        file.string() +
        ": has no column timestamp_s, timestamp, time_s or time; name one with --times, or use --rate");
}

/// Numbers of one column below the header. Throws InputError at a line that lacks one.
std::vector<double> read_column(const std::vector<std::string>& lines, bool header, std::size_t column,
                                const fs::path& file, const std::string& what) {
    std::vector<double> values;
    for (std::size_t i = header ? 1 : 0; i < lines.size(); ++i) {
        const auto numbers = numbers_of(lines[i]);
        if (numbers.size() <= column)
            throw InputError(file.string() + ", line " + std::to_string(i + 1) + ": holds no " + what);
        values.push_back(numbers[column]);
    }
    return values;
}

/// File with times in the folder or its parent; empty when there is none.
fs::path find_times_file(const fs::path& directory) {
    const fs::path inside = directory / "";
    for (const fs::path& folder : {inside.parent_path(), inside.parent_path().parent_path()}) {
        for (const char* name : {"times.txt", "log.csv"}) {
            if (fs::is_regular_file(folder / name)) return folder / name;
        }
    }
    return {};
}

void require_rising(const std::vector<double>& times_s, const fs::path& file) {
    for (std::size_t i = 1; i < times_s.size(); ++i) {
        if (times_s[i] > times_s[i - 1]) continue;
        throw InputError(file.string() + ": the time of row " + std::to_string(i + 1) +
                         " is not later than the one before; correct it, or use --rate");
    }
}

}  // namespace

std::vector<double> read_times_file(const fs::path& file) {
    const auto lines = read_lines(file);
    if (lines.empty()) throw InputError(file.string() + ": is empty");
    bool header = false;
    const std::size_t column = time_column(lines.front(), file, header);
    std::vector<double> times_s = read_column(lines, header, column, file, "time");
    require_rising(times_s, file);
    return times_s;
}

std::vector<GyroRate> read_gyro_file(const fs::path& file) {
    const std::vector<double> times_s = read_times_file(file);
    const auto lines = read_lines(file);
    const auto in_degrees = column_of(lines.front(), {"gyro_z_degps"});
    const auto column = in_degrees ? in_degrees : column_of(lines.front(), {"gyro_z_radps"});
    if (!column) return {};
    const std::vector<double> rates = read_column(lines, true, *column, file, "turn rate");
    std::vector<GyroRate> readings;
    for (std::size_t i = 0; i + 1 < times_s.size(); ++i)
        readings.push_back({0.5 * (times_s[i] + times_s[i + 1]), rates[i] * (in_degrees ? degree_rad : 1.0)});
    return readings;
}

ImageFolder::ImageFolder(const fs::path& directory, config::CameraConfig camera, const FrameTimes& times)
    : images_(list_images(directory)), camera_(std::move(camera)) {
    fs::path file = times.file;
    if (file.empty() && !times.rate_hz) file = find_times_file(directory);
    if (!file.empty()) {
        times_s_ = read_times_file(file);
        gyro_ = read_gyro_file(file);
        times_source_ = file.string();
        if (times_s_.size() >= images_.size()) return;
        throw InputError(file.string() + ": holds " + std::to_string(times_s_.size()) + " times for " +
                         std::to_string(images_.size()) + " images; use --rate, or another --times");
    }
    const double rate_hz = times.rate_hz.value_or(times.default_rate_hz);
    for (std::size_t i = 0; i < images_.size(); ++i) times_s_.push_back(static_cast<double>(i) / rate_hz);
    std::ostringstream text;
    text << rate_hz << " images a second";
    times_source_ = text.str();
}

std::optional<SequenceFrame> ImageFolder::next() {
    while (at_ < images_.size()) {
        const std::size_t i = at_++;
        auto field = load_grey(images_[i]);
        if (!field) {
            add_problem(images_[i].string() + ": cannot be read as a picture");
            continue;
        }
        field->timestamp_s = times_s_[i];
        field->camera = camera_model(camera_, field->image.width_px, field->image.height_px);
        return SequenceFrame{*field, std::nullopt};
    }
    return std::nullopt;
}

}  // namespace flownav::io
