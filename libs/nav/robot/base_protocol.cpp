#include "flownav/nav/base_protocol.h"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace flownav::nav {
namespace base_protocol {
namespace {

constexpr std::string_view greeting = "flownav-base";

std::vector<std::string_view> words_of(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    std::vector<std::string_view> words;
    for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(blanks, end);
    }
    return words;
}

template <typename Number>
bool read(std::string_view word, Number& number) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
}

/// Parses the words after the first as `n` finite numbers. Returns false when one is malformed.
template <std::size_t n>
bool read_all(const std::vector<std::string_view>& words, std::array<double, n>& numbers) {
    for (std::size_t i = 0; i < n; ++i)
        if (!read(words[i + 1], numbers[i]) || !std::isfinite(numbers[i])) return false;
    return true;
}

std::string decimal(double number) {
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return {buffer.data(), end};
}

Line malformed(std::string_view line, std::string_view usage) {
    const std::string shown(line.substr(0, 60));
    return Malformed{"'" + shown + "' is not: " + std::string(usage)};
}

Line parse_hello(std::string_view line, const std::vector<std::string_view>& words) {
    Hello hello;
    const bool good = (words.size() == 3 || words.size() == 4) && words[1] == greeting &&
                      read(words[2], hello.version) &&
                      (words.size() == 3 || (read(words[3], hello.timeout_ms) && hello.timeout_ms > 0));
    return good ? Line(hello) : malformed(line, "hello flownav-base VERSION [TIMEOUT_MS]");
}

Line parse_drive(std::string_view line, const std::vector<std::string_view>& words) {
    std::array<double, 2> numbers{};
    long sequence = 0;
    if (words.size() != 4 || !read_all(words, numbers) || !read(words[3], sequence)) {
        return malformed(line, "drive V OMEGA SEQ");
    }
    return Drive{{numbers[0], numbers[1]}, sequence};
}

Line parse_odometry(std::string_view line, const std::vector<std::string_view>& words) {
    std::array<double, 6> n{};
    if (words.size() != 7 || !read_all(words, n)) return malformed(line, "odometry TIME X Y YAW V OMEGA");
    return WheelReading{n[0], {n[1], n[2], n[3]}, {n[4], n[5]}};
}

}  // namespace

Line parse(std::string_view line) {
    if (line.size() > line_max) return malformed(line, "a line of at most 200 bytes");
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty()) return malformed(line, "a line with a word");
    if (words[0] == "odometry") return parse_odometry(line, words);
    if (words[0] == "drive") return parse_drive(line, words);
    if (words[0] == "hello") return parse_hello(line, words);
    if (words[0] == "stopped" && words.size() == 1) return Stopped{};
    if (words[0] == "bye" && words.size() == 1) return Bye{};
    if (words[0] == "error" && words.size() > 1)
        return Complaint{std::string(line.substr(words[1].data() - line.data()))};
    return malformed(line, "hello, drive, odometry, stopped, error or bye");
}

std::string text(const Hello& hello) {
    std::string line = "hello " + std::string(greeting) + " " + std::to_string(hello.version);
    if (hello.timeout_ms > 0) line += " " + std::to_string(hello.timeout_ms);
    return line + "\n";
}

std::string text(const Drive& drive) {
    return "drive " + decimal(drive.command.v_mps) + " " + decimal(drive.command.omega_radps) + " " +
           std::to_string(drive.sequence) + "\n";
}

std::string text(const WheelReading& r) {
    std::string line = "odometry";
    for (const double number : {r.time_s, r.T_odom_robot.x_m, r.T_odom_robot.y_m, r.T_odom_robot.yaw_rad,
                                r.motion.v_mps, r.motion.omega_radps})
        line += " " + decimal(number);
    return line + "\n";
}

std::string text(const Stopped&) {
    return "stopped\n";
}

std::string text(const Complaint& complaint) {
    return "error " + complaint.text.substr(0, line_max - 10) + "\n";
}

std::string text(const Bye&) {
    return "bye\n";
}

}  // namespace base_protocol

std::optional<std::string> LineBuffer::next() {
    const std::size_t end = bytes_.find('\n');
    if (end == std::string::npos) return {};
    std::string line = bytes_.substr(0, end);
    bytes_.erase(0, end + 1);
    return line;
}

}  // namespace flownav::nav
