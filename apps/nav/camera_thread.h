#pragma once

#include <atomic>
#include <mutex>
#include <thread>

#include "flownav/pipeline/repeated_images.h"
#include "flownav/producer/live_fields.h"
#include "robot_drive.h"

namespace flownav {

/// The flow sensor of a live camera: reads fields and works on them in a thread of its own.
class CameraThread : public SensorFeed {
  public:
    /// Opens the camera. Throws InputError: it is not there.
    explicit CameraThread(const ProducerSettings& settings);
    ~CameraThread() override;

    std::vector<nav::Sensed> arrived() override;
    std::string end() override;

  private:
    void run();

    LiveFields fields_;
    std::mutex mutex_;
    std::vector<nav::Sensed> arrived_;
    std::string end_;
    std::atomic<bool> stops_{false};
    std::thread thread_;  ///< last: starts when all else is there
};

/// What a field's record says, for the autopilot; times less `epoch_s`. `images`: fed with every field.
nav::Sensed sensed_of(const pipeline::Step& step, const Field& field, pipeline::RepeatedImages& images,
                      double epoch_s = 0.0);

}  // namespace flownav
