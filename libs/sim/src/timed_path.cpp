#include "flownav/sim/timed_path.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

namespace flownav::sim {
namespace {

namespace fs = std::filesystem;

/// Share of the way from the identity to `to`, which is an arc.
Pose2 part_of_arc(const Pose2& to, double share) {
    const double chord_m = std::hypot(to.x_m, to.y_m);
    const double turn_rad = wrap_angle(to.yaw_rad);
    const double half_rad = turn_rad / 2;
    const double aside_rad = chord_m > 0.0 ? std::atan2(to.y_m, to.x_m) - half_rad : 0.0;
    const double chord_share =
        std::abs(half_rad) < 1e-9 ? share : std::sin(share * half_rad) / std::sin(half_rad);
    return along_arc(share * turn_rad, chord_m * chord_share, aside_rad);
}

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',') {
            cells.emplace_back();
        } else if (c != ' ' && c != '\t' && c != '\r') {
            cells.back() += c;
        }
    }
    return cells;
}

[[noreturn]] void refuse(const fs::path& file, int line, const std::string& what) {
    throw PathError(file.string() + ":" + std::to_string(line) + ": " + what);
}

double number(const std::string& cell, const fs::path& file, int line) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
        refuse(file, line, "\"" + cell + "\" is not a number");
    return value;
}

constexpr std::array<std::string_view, 4> column_names = {"time_s", "x_m", "y_m", "yaw_rad"};
using Columns = std::array<std::optional<std::size_t>, 4>;

Columns read_header(const std::string& line, const fs::path& file) {
    const std::vector<std::string> names = split(line);
    Columns columns;
    for (std::size_t i = 0; i < column_names.size(); ++i) {
        const auto found = std::find(names.begin(), names.end(), column_names[i]);
        if (found != names.end()) {
            columns[i] = static_cast<std::size_t>(found - names.begin());
        } else if (i > 0) {
            refuse(file, 1,
                   "the first line must name the columns x_m, y_m, yaw_rad, and time_s where "
                   "the path has times; " +
                       std::string(column_names[i]) + " is missing");
        }
    }
    return columns;
}

PathPoint read_row(const std::string& line, const Columns& columns, const fs::path& file,
                   int number_of_line) {
    const std::vector<std::string> cells = split(line);
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i]) continue;
        if (*columns[i] >= cells.size()) refuse(file, number_of_line, "too few columns");
        values[i] = number(cells[*columns[i]], file, number_of_line);
    }
    return {values[0], {values[1], values[2], values[3]}};
}

double duration_s(const Pose2& from, const Pose2& to, const PathSpeed& speed) {
    const Pose2 moved = compose(inverse(from), to);
    const double half_rad = std::abs(wrap_angle(moved.yaw_rad)) / 2;
    const double arc_per_chord = half_rad < 1e-9 ? 1.0 : half_rad / std::sin(half_rad);
    return std::max(std::hypot(moved.x_m, moved.y_m) * arc_per_chord / speed.v_mps,
                    2 * half_rad / speed.omega_radps);
}

}  // namespace

TimedPath::TimedPath(std::vector<PathPoint> points) : points_(std::move(points)) {
    if (points_.empty()) throw PathError("a path needs at least one point");
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const auto& [time_s, pose] = points_[i];
        if (!std::isfinite(time_s + pose.x_m + pose.y_m + pose.yaw_rad))
            throw PathError("point " + std::to_string(i + 1) + " of a path is not a number");
        if (i > 0 && time_s <= points_[i - 1].time_s) {
            throw PathError("the time of point " + std::to_string(i + 1) +
                            " of a path is not later than the one before");
        }
    }
}

Pose2 TimedPath::at(double time_s) const {
    const auto next = std::upper_bound(points_.begin(), points_.end(), time_s,
                                       [](double t, const PathPoint& point) { return t < point.time_s; });
    if (next == points_.begin()) return points_.front().T_world_robot;
    const PathPoint& last = *(next - 1);
    if (next == points_.end()) return last.T_world_robot;
    const double share = (time_s - last.time_s) / (next->time_s - last.time_s);
    const Pose2 moved = compose(inverse(last.T_world_robot), next->T_world_robot);
    return compose(last.T_world_robot, part_of_arc(moved, share));
}

TimedPath read_path(const fs::path& file, const std::optional<PathSpeed>& speed) {
    std::ifstream in(file);
    if (!in || fs::is_directory(file)) throw PathError(file.string() + ": cannot be opened");
    std::string line;
    std::getline(in, line);
    if (line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);  // a byte order mark
    const Columns columns = read_header(line, file);
    if (!columns[0] && !speed) refuse(file, 1, "without the column time_s a speed must be given");
    std::vector<PathPoint> points;
    for (int n = 2; std::getline(in, line); ++n) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        PathPoint point = read_row(line, columns, file, n);
        if (!columns[0] && !points.empty()) {
            const double more_s = duration_s(points.back().T_world_robot, point.T_world_robot, *speed);
            if (more_s <= 0.0) continue;  // the same point twice
            point.time_s = points.back().time_s + more_s;
        }
        if (!points.empty() && point.time_s <= points.back().time_s)
            refuse(file, n, "time_s is not later than in the row before");
        points.push_back(point);
    }
    if (points.empty()) refuse(file, 1, "no point follows the names of the columns");
    const double begin_s = points.front().time_s;
    for (PathPoint& point : points) point.time_s -= begin_s;
    return TimedPath(std::move(points));
}

}  // namespace flownav::sim
