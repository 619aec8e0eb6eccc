#pragma once

namespace flownav::nav {

/// Takes what a navigator tells the watchdog of its robot: from start to stop, a command or a sign of life
/// is due within every period.
class WatchdogSink {
  public:
    WatchdogSink() = default;
    virtual ~WatchdogSink() = default;
    WatchdogSink(const WatchdogSink&) = delete;
    WatchdogSink& operator=(const WatchdogSink&) = delete;

    virtual void start_watchdog(double period_s) = 0;
    virtual void stop_watchdog() = 0;
    /// The navigator has decided, or keeps to its last decision.
    virtual void alive() = 0;
};

}  // namespace flownav::nav
