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

/// State of a sensor.
struct SensorState {
    enum class Phase {
        Running,
        Ended,   ///< a file was read to its regular end, or the sensor was stopped
        Failed,  ///< `message` has the reason
    };
    Phase phase = Phase::Running;
    std::string message;
    double silent_s = 0.0;  ///< since its last observation or its start
};

/// Runs one sensor in its own thread, at its process_rate, and passes on its observations.
class SensorThread {
  public:
    SensorThread(SensorSetup setup, std::shared_ptr<DiskWriter> writer);

    /// Ends the sensor; a driver that hangs is left running.
    ~SensorThread();
    SensorThread(const SensorThread&) = delete;
    SensorThread& operator=(const SensorThread&) = delete;

    /// Asks the sensor to end after its current turn. Returns at once.
    void stop();

    /// Waits until the sensor has ended and all its observations were passed on. Returns false when it hangs.
    bool wait_until(std::chrono::steady_clock::time_point latest);

    SensorState state() const;
    const std::string& name() const;

  private:
    struct Shared;
    std::shared_ptr<Shared> shared_;  ///< outlives this object when the driver hangs
    std::thread thread_;
};

}  // namespace flownav
