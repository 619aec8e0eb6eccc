#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "disk_writer.h"
#include "sensor_setup.h"

namespace flownav {

/// How a sensor is doing.
struct SensorState {
    enum class Phase {
        Running,
        Ended,   ///< a file was read to its regular end, or the sensor was stopped
        Failed,  ///< `message` says how
    };
    Phase phase = Phase::Running;
    std::string message;
    double silent_s = 0.0;  ///< since its last observation, or since it was started
};

/// Runs one sensor in a thread of its own, at its process_rate, and passes on all that it observes.
class SensorThread {
  public:
    SensorThread(SensorSetup setup, std::shared_ptr<DiskWriter> writer);

    /// Ends the sensor, if need be without it: a driver that hangs is left behind.
    ~SensorThread();
    SensorThread(const SensorThread&) = delete;
    SensorThread& operator=(const SensorThread&) = delete;

    /// Asks the sensor to end after its current turn. Returns at once.
    void stop();

    /// Waits until it has ended and all its observations were passed on; false: it hangs.
    bool wait_until(std::chrono::steady_clock::time_point latest);

    SensorState state() const;
    const std::string& name() const;

  private:
    struct Shared;
    std::shared_ptr<Shared> shared_;  ///< outlives this where the driver hangs
    std::thread thread_;
};

}  // namespace flownav
