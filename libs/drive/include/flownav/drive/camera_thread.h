#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "flownav/drive/clock.h"
#include "flownav/drive/sensor_feed.h"
#include "flownav/io/live_fields.h"

namespace flownav::drive {

/// Called with every field and its record, in the camera's thread.
using FieldSink = std::function<void(const Field&, const pipeline::Step&)>;

/// The flow sensor of a camera: reads and processes fields in its own thread. Time stamps are in the clock of
/// the drive: the capture time for a live camera; for a recording (a rawlog, a folder of images, a video
/// file), as if it began now. A recording is read at its own pace. An exception in the thread ends the feed;
/// end() returns its message.
class CameraThread : public SensorFeed {
  public:
    /// Opens the camera. Throws InputError when it cannot be opened. The clock must outlive this object.
    CameraThread(const io::ProducerSettings& settings, const SteadyClock& clock, FieldSink sink);
    ~CameraThread() override;

    void odometry(const nav::WheelReading& reading) override;
    std::vector<nav::SensorUpdate> arrived() override;
    std::string end() override;

  private:
    void run();
    void read_fields();
    double clock_time_s(double timestamp_s);
    std::vector<WheelPose> new_wheels();

    io::LiveFields fields_;
    const SteadyClock& clock_;
    FieldSink sink_;
    bool recorded_;                          ///< the source is a recording
    std::optional<double> recording_began_;  ///< clock - time stamp of a recording
    std::mutex mutex_;
    std::vector<nav::SensorUpdate> arrived_;
    std::vector<WheelPose> wheels_;  ///< readings that the thread has not taken yet
    std::string end_;
    std::atomic<bool> stops_{false};
    std::thread thread_;  ///< last: starts when all other members exist
};

}  // namespace flownav::drive
