#pragma once

#include <functional>
#include <optional>
#include <string>

#include "flownav/nav/base_protocol.h"
#include "flownav/nav/tcp_socket.h"
#include "flownav/sim/vehicle.h"

namespace flownav::testing {

struct ReferenceBaseOptions {
    int port = 0;  ///< 0: the system chooses one
    RobotModel robot;
    double rate_hz = 50.0;  ///< of the odometry
    int timeout_ms = 300;   ///< without a command it stops by itself
};

/// The program of a base, as share/doc/robot.md asks for it: one connection at a time, a simulated robot
/// with two driven wheels in real time. Shows how little a real one needs.
class ReferenceBase {
  public:
    explicit ReferenceBase(const ReferenceBaseOptions& options);

    int port() const { return listener_.port(); }

    /// Serves one connection after the other until `ended` says so; asks it some 50 times a second.
    void serve(const std::function<bool()>& ended);

  private:
    void serve_one(const std::function<bool()>& ended);
    void answer(const std::string& line);
    void watch();
    double now_s() const;

    ReferenceBaseOptions options_;
    nav::TcpListener listener_;
    sim::Vehicle vehicle_;
    std::optional<nav::TcpSocket> client_;
    nav::LineBuffer lines_;
    long sequence_ = 0;
    double commanded_s_ = 0.0;
    bool moves_ = false;  ///< a command is in force
    bool greeted_ = false;
    bool over_ = false;
    double start_s_;
};

}  // namespace flownav::testing
