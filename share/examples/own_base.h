#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <string>

#include "flownav/nav/robot_base.h"

/// Two driven wheels behind a motor controller at a serial line: we write "m LEFT RIGHT" (ticks a second),
/// it writes "e LEFT RIGHT" (ticks so far) some 50 times a second.
class SerialBase : public flownav::nav::RobotBase {
  public:
    explicit SerialBase(const std::string& device)
        : file_(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)) {
        if (file_ < 0) throw flownav::nav::RobotError("cannot open " + device + ": is the robot plugged in?");
        termios line{};
        ::tcgetattr(file_, &line);
        ::cfmakeraw(&line);
        ::cfsetspeed(&line, B115200);
        ::tcsetattr(file_, TCSANOW, &line);
    }
    ~SerialBase() override { ::close(file_); }

    std::optional<flownav::nav::WheelReading> odometry() override {
        std::optional<flownav::nav::WheelReading> newest;
        char c = 0;
        while (::read(file_, &c, 1) == 1) {
            if (c != '\n') {
                line_ += c;
                continue;
            }
            long left = 0, right = 0;
            if (std::sscanf(line_.c_str(), "e %ld %ld", &left, &right) == 2) newest = counted(left, right);
            line_.clear();
        }
        return newest;
    }

    void drive(const flownav::MotionCommand& command) override {
        const double turn_mps = command.omega_radps * track_m / 2;
        char line[64];
        const int size = std::snprintf(line, sizeof line, "m %ld %ld\n", ticks(command.v_mps - turn_mps),
                                       ticks(command.v_mps + turn_mps));
        const std::lock_guard lock(writing_);  // stop() may come from the watchdog's thread
        if (::write(file_, line, static_cast<std::size_t>(size)) != size)
            throw flownav::nav::RobotError("the serial line of the robot is gone: check the cable");
    }

  private:
    static constexpr double track_m = 0.4;  // between the wheels
    static constexpr double ticks_per_m = 10000.0;

    static long ticks(double metres) { return std::lround(metres * ticks_per_m); }

    flownav::nav::WheelReading counted(long left, long right) {
        flownav::nav::WheelReading reading;
        // The cameras of flownav stamp with the system's clock.
        reading.time_s =
            std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
        if (last_.time_s > 0.0) {
            const double left_m = static_cast<double>(left - left_) / ticks_per_m;
            const double right_m = static_cast<double>(right - right_) / ticks_per_m;
            const double turn_rad = (right_m - left_m) / track_m;
            const double dt_s = std::max(1e-3, reading.time_s - last_.time_s);
            reading.T_odom_robot =
                compose(last_.T_odom_robot, flownav::along_arc(turn_rad, (left_m + right_m) / 2));
            reading.motion = {(left_m + right_m) / 2 / dt_s, turn_rad / dt_s};
        }
        left_ = left;
        right_ = right;
        last_ = reading;
        return reading;
    }

    int file_;
    std::mutex writing_;
    std::string line_;
    long left_ = 0, right_ = 0;
    flownav::nav::WheelReading last_;
};
