#include "flownav/nav/tcp_robot.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace flownav::nav {
namespace {

using namespace base_protocol;

constexpr double drift = 1e-4;      // between two clocks, seconds per second
constexpr int full_reads_max = 25;  // half a second of control ticks

double system_clock_s() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

double steady_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

TcpAddress parse_tcp_address(const std::string& text) {
    constexpr std::string_view scheme = "tcp:";
    const std::size_t colon = text.rfind(':');
    const bool good =
        text.compare(0, scheme.size(), scheme) == 0 && colon > scheme.size() && colon + 1 < text.size();
    if (!good) {
        throw std::invalid_argument(
            "'" + text + "' is no address of a robot: tcp:HOST:PORT, such as tcp:192.168.1.5:4242");
    }
    std::string host = text.substr(scheme.size(), colon - scheme.size());
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    return {host, text.substr(colon + 1)};
}

double ClockOffset::update(double arrival_s, double stamp_s) {
    const double elapsed_s = std::max(0.0, arrival_s - last_s_);
    offset_s_ = std::min(offset_s_ + drift * elapsed_s, arrival_s - stamp_s);
    last_s_ = arrival_s;
    return offset_s_;
}

TcpRobot::TcpRobot(const TcpAddress& address, const TcpRobotParams& params)
    : address_(address), params_(params), socket_(address.host, address.port, params.connect_s) {
    if (!params_.clock_s) params_.clock_s = system_clock_s;
    greet(params.connect_s);
    heard_s_ = steady_s();
}

TcpRobot::~TcpRobot() {
    try {
        socket_.send(text(Drive{{}, ++sequence_}) + text(Bye{}));
    } catch (const RobotError&) {
        // The connection is lost; the base stops by itself.
    }
}

void TcpRobot::lose(const std::string& why) const {
    throw RobotError("lost the robot at tcp:" + address_.host + ":" + address_.port + ": " + why +
                     "; it stops by itself, start again when it is back");
}

void TcpRobot::greet(double timeout_s) {
    socket_.send(text(Hello{version, 0}));
    const double end_s = steady_s() + timeout_s;
    while (true) {
        const double left_s = end_s - steady_s();
        if (left_s <= 0.0 || !socket_.wait(left_s)) lose("no hello");
        lines_.add(socket_.receive());
        const std::optional<std::string> line = lines_.next();
        if (lines_.is_overlong()) lose("this is not the program of a base");
        if (!line) continue;
        const Line parsed = parse(*line);
        if (const auto* complaint = std::get_if<Complaint>(&parsed)) lose("it says: " + complaint->text);
        const auto* hello = std::get_if<Hello>(&parsed);
        if (hello == nullptr || hello->timeout_ms <= 0)
            lose("its first line is '" + line->substr(0, 60) + "'");
        if (hello->version != version) {
            lose("it speaks version " + std::to_string(hello->version) + ", not " + std::to_string(version));
        }
        base_timeout_s_ = hello->timeout_ms / 1000.0;
        return;
    }
}

std::optional<WheelReading> TcpRobot::odometry() {
    try {
        const std::string bytes = socket_.receive();
        full_reads_ = bytes.size() < TcpSocket::receive_max ? 0 : full_reads_ + 1;
        lines_.add(bytes);
    } catch (const RobotError& error) {
        lose(error.what());
    }
    if (full_reads_ >= full_reads_max) lose("it sends faster than can be read");
    newest_.reset();
    while (const std::optional<std::string> line = lines_.next()) {
        heard_s_ = steady_s();
        take(parse(*line));
    }
    if (lines_.is_overlong()) lose("it sends lines without an end");
    if (steady_s() - heard_s_ > params_.silence_s) lose("it is silent");
    return newest_;
}

void TcpRobot::take(const Line& line) {
    if (const auto* reading = std::get_if<WheelReading>(&line)) {
        newest_ = *reading;
        newest_->time_s += offset_.update(params_.clock_s(), reading->time_s);
    } else if (std::holds_alternative<Stopped>(line)) {
        ++stops_;
    } else if (const auto* complaint = std::get_if<Complaint>(&line)) {
        complaint_ = complaint->text;
    } else if (std::holds_alternative<Bye>(line)) {
        lose("it said bye");
    } else {
        ++malformed_;
    }
}

void TcpRobot::drive(const MotionCommand& command) {
    const std::lock_guard lock(sending_);
    try {
        socket_.send(text(Drive{command, ++sequence_}));
    } catch (const RobotError& error) {
        lose(error.what());
    }
}

}  // namespace flownav::nav
