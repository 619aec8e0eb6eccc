#pragma once

#include <mrpt/core/Clock.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "flownav/drive/clock.h"

namespace flownav::drive {

/// A clock that advances only in wait_until_s(). Sets MRPT's clock to this time plus `epoch_s` during its
/// lifetime.
class SimulatedClock : public Clock {
  public:
    /// `realtime`: waiting also takes real time.
    SimulatedClock(double epoch_s, bool realtime) : epoch_s_(epoch_s), realtime_(realtime) {
        mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
        show();
    }
    ~SimulatedClock() override { mrpt::Clock::setActiveClock(mrpt::Clock::Realtime); }

    double now_s() const override { return now_s_; }
    void wait_until_s(double time_s) override {
        now_s_ = std::max(now_s_, time_s);
        show();
        if (realtime_) std::this_thread::sleep_until(began_ + std::chrono::duration<double>(now_s_));
    }

  private:
    void show() const { mrpt::Clock::setSimulatedTime(mrpt::Clock::fromDouble(epoch_s_ + now_s_)); }

    double epoch_s_;
    bool realtime_;
    double now_s_ = 0.0;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace flownav::drive
