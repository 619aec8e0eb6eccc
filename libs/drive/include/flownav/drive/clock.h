#pragma once

#include <chrono>
#include <functional>

namespace flownav::drive {

/// The clock of a drive: the readings of the wheels and the fields are stamped with it.
class Clock {
  public:
    Clock() = default;
    virtual ~Clock() = default;
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

    /// Seconds; never goes back.
    virtual double now_s() const = 0;

    /// Returns at that time, or soon after it; at once when it is over.
    virtual void wait_until_s(double time_s) = 0;
};

/// Seconds since 1970 as the system's clock showed them when this was made, counted on by a steady clock: a
/// system clock that is set during the drive moves nothing.
class SteadyClock : public Clock {
  public:
    SteadyClock();

    double now_s() const override;
    void wait_until_s(double time_s) override;

    /// The time of this clock at which the system's clock showed `system_s`, if it has not been set since.
    double from_system_s(double system_s) const;

  private:
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    double began_s_;
};

/// The time that the system's clock shows, seconds since 1970.
double system_time_s();

}  // namespace flownav::drive
