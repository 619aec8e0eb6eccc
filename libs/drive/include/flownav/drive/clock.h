#pragma once

#include <chrono>
#include <functional>

namespace flownav::drive {

/// The clock of a drive; stamps wheel readings and fields.
class Clock {
  public:
    Clock() = default;
    virtual ~Clock() = default;
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

    /// Seconds, monotonic.
    virtual double now_s() const = 0;

    /// Returns at `time_s` or soon after; at once when it has passed.
    virtual void wait_until_s(double time_s) = 0;
};

/// Seconds since 1970: the system time at construction, advanced by a steady clock. Setting the system clock
/// during the drive has no effect.
class SteadyClock : public Clock {
  public:
    SteadyClock();

    double now_s() const override;
    void wait_until_s(double time_s) override;

    /// Converts a system time to the time of this clock, assuming that the system clock has not been set
    /// since.
    double from_system_s(double system_s) const;

  private:
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    double began_s_;
};

/// The current system time, seconds since 1970.
double system_time_s();

}  // namespace flownav::drive
