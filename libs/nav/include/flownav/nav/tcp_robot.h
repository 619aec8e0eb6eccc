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
    double connect_s = 3.0;  ///< for the connection and the base's hello
    double silence_s = 2.0;  ///< without a line from the base, the connection counts as lost
    /// The clock of the camera's fields, in seconds; empty: the system's, since 1970.
    std::function<double()> clock_s;
};

/// What to add to the times of another clock. Lines arrive late, never early: the smallest difference of
/// arrival and time stamp is the truest; it is forgotten slowly, as clocks drift.
class ClockOffset {
  public:
    double update(double arrival_s, double stamp_s);

  private:
    double offset_s_ = std::numeric_limits<double>::infinity();
    double last_s_ = 0.0;
};

/// A base behind a TCP connection; share/doc/robot.md documents its lines. A lost connection is not opened
/// again: odometry() and drive() throw RobotError, and the base stops by itself.
class TcpRobot : public RobotBase {
  public:
    /// Connects and exchanges hellos. Throws RobotError.
    explicit TcpRobot(const TcpAddress& address, const TcpRobotParams& params = {});
    ~TcpRobot() override;

    std::optional<WheelReading> odometry() override;
    void drive(const MotionCommand& command) override;

    /// Waits for lines of the base; false: none came.
    bool wait(double timeout_s) const { return socket_.wait(timeout_s); }

    /// After so long without a command the base stops by itself.
    double base_timeout_s() const { return base_timeout_s_; }
    int malformed_lines() const { return malformed_; }                ///< of the base
    int stops_of_base() const { return stops_; }                      ///< how often it stopped by itself
    const std::string& last_complaint() const { return complaint_; }  ///< of the base about us

  private:
    void greet(double timeout_s);
    void take(const base_protocol::Line& line);
    [[noreturn]] void lose(const std::string& why) const;

    TcpAddress address_;
    TcpRobotParams params_;
    TcpSocket socket_;
    std::mutex sending_;  ///< drive() and a stop() of another thread
    LineBuffer lines_;
    ClockOffset offset_;
    std::optional<WheelReading> newest_;
    double heard_s_ = 0.0;  ///< when the last line came
    double base_timeout_s_ = 0.0;
    long sequence_ = 0;
    int malformed_ = 0;
    int full_reads_ = 0;  ///< in a row: more came than was read
    int stops_ = 0;
    std::string complaint_;
};

}  // namespace flownav::nav
