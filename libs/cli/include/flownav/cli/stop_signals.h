#pragma once
#include <chrono>
#include <csignal>
#include <initializer_list>

namespace flownav::cli {

/// SIGINT, SIGTERM and SIGHUP as something to wait for: they interrupt nothing. To be made before any thread,
/// which inherits it.
class StopSignals {
  public:
    StopSignals();

    /// Waits for one of them; true: it came.
    bool wait(std::chrono::milliseconds time) const;

    /// From now on they end the program again, in the calling thread; those that came before are forgotten.
    void release() const;

  private:
    sigset_t signals_{};
};

}  // namespace flownav::cli
