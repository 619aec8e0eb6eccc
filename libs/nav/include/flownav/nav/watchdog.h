#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "flownav/nav/watchdog_sink.h"

namespace flownav::nav {

/// A thread that stops a robot whose navigator hangs: calls `stop` when nobody said alive() for a period,
/// once for every silence. Steady clock; for real robots (a simulated one has Guard's silent_s). `stop` runs
/// in the watchdog's thread, must not throw, and must not call the watchdog.
class Watchdog : public WatchdogSink {
  public:
    explicit Watchdog(std::function<void()> stop);
    ~Watchdog() override;

    /// Throws std::invalid_argument when the period is negative or not a number.
    void start_watchdog(double period_s) override;
    void stop_watchdog() override;
    void alive() override;

  private:
    using Clock = std::chrono::steady_clock;
    enum class State { Off, Waiting, Expired, Ended };

    void watch();

    std::function<void()> stop_;
    std::mutex mutex_;
    std::condition_variable changed_;
    State state_ = State::Off;
    Clock::duration period_{};
    Clock::time_point due_;
    std::thread thread_;  ///< last: starts when all else is there
};

}  // namespace flownav::nav
