#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "disk_writer.h"
#include "sensor_setup.h"
#include "sensor_thread.h"

namespace flownav {

struct GrabOptions {
    RecordingOptions recording;
    double duration_s = 0.0;  ///< recording time; 0: until stopped or every source has ended
    double silence_s = 10.0;  ///< a sensor without observations for longer has failed; 0: no limit
    std::uint64_t queue_bytes = 256U << 20;  ///< limit of observations waiting for the disk
};

enum class GrabStatus {
    Fine = 0,
    Usage = 1,    ///< bad usage or configuration; nothing was written
    Sensor = 2,   ///< a sensor failed; the recording holds all that was captured before
    Output = 3,   ///< the disk failed; the recording ends before that
    Dropped = 4,  ///< the disk was too slow, and observations were dropped
};

struct GrabResult {
    GrabStatus status = GrabStatus::Fine;
    std::vector<std::string> messages;  ///< sensor or file, and reason
    bool hanging = false;               ///< a driver did not end; the program must exit without it
};

/// Records sensors into a rawlog until told to stop.
class Grabber {
  public:
    /// Opens the recording and starts the sensors. Throws OutputError.
    Grabber(const GrabSetup& setup, const GrabOptions& options);

    /// True when recording is over: every source has ended, something failed, or the time is over.
    bool done() const;

    /// Ends the sensors, writes all remaining observations, and closes the recording.
    GrabResult finish();

    WriterCounts counts() const { return writer_->counts(); }
    std::vector<std::filesystem::path> files() const { return writer_->files(); }
    double elapsed_s() const;

  private:
    std::string failure_of(const SensorThread& sensor) const;

    GrabOptions options_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::shared_ptr<DiskWriter> writer_;
    std::vector<std::unique_ptr<SensorThread>> sensors_;
};

}  // namespace flownav
