#pragma once

#include <functional>
#include <limits>
#include <mutex>
#include <string>

#include "flownav/nav/base_protocol.h"
#include "flownav/nav/robot_base.h"
#include "flownav/nav/tcp_socket.h"

namespace flownav::nav {

struct TcpAddress {
    std::string host;
    std::string port;
};

/// Reads `tcp:HOST:PORT` (an IPv6 address in brackets). Throws std::invalid_argument.
TcpAddress parse_tcp_address(const std::string& text);

struct TcpRobotParams {
    double connect_s = 3.0;  ///< limit for the connection and the base's hello
    double silence_s = 2.0;  ///< time without a line from the base after which the connection is lost
    /// The clock of the camera's fields, in seconds; empty: the system's, since 1970.
    std::function<double()> clock_s;
};

/// Offset to add to the time stamps of another clock: the smallest difference of arrival and time stamp,
/// because lines arrive late but never early. The minimum decays slowly to follow clock drift.
class ClockOffset {
  public:
    double update(double arrival_s, double stamp_s);

  private:
    double offset_s_ = std::numeric_limits<double>::infinity();
    double last_s_ = 0.0;
};

/// A base behind a TCP connection; share/doc/robot.md documents its lines. A lost connection is not reopened:
/// odometry() and drive() throw RobotError, and the base stops by itself.
class TcpRobot : public RobotBase {
  public:
    /// Connects and exchanges hellos. Throws RobotError.
    explicit TcpRobot(const TcpAddress& address, const TcpRobotParams& params = {});
    ~TcpRobot() override;

    std::optional<WheelReading> odometry() override;
    void drive(const MotionCommand& command) override;

    /// Waits for lines of the base. Returns false on timeout.
    bool wait(double timeout_s) const { return socket_.wait(timeout_s); }

    /// Time without a command after which the base stops by itself.
    double base_timeout_s() const { return base_timeout_s_; }
    int malformed_lines() const { return malformed_; }  ///< lines of the base that could not be parsed
    int stops_of_base() const { return stops_; }        ///< how often the base stopped by itself
    const std::string& last_complaint() const { return complaint_; }  ///< last error line from the base

  private:
    void greet(double timeout_s);
    void take(const base_protocol::Line& line);
    [[noreturn]] void lose(const std::string& why) const;

    TcpAddress address_;
    TcpRobotParams params_;
    TcpSocket socket_;
    std::mutex sending_;  ///< serialises drive() with a stop() of another thread
    LineBuffer lines_;
    ClockOffset offset_;
    std::optional<WheelReading> newest_;
    double heard_s_ = 0.0;  ///< when the last line arrived
    double base_timeout_s_ = 0.0;
    long sequence_ = 0;
    int malformed_ = 0;
    int full_reads_ = 0;  ///< consecutive reads that left data unread
    int stops_ = 0;
    std::string complaint_;
};

}  // namespace flownav::nav
