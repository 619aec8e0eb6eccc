#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "flownav/io/event_maker.h"
#include "flownav/io/producer_settings.h"

namespace flownav::io {

/// The fields (and poses) of a source that is opened as a sensor of rawlog-grabber: a camera, a stream, a
/// video, a folder of images or a rawlog. CFlowObstacleSensor is built on this.
class LiveFields {
  public:
    /// Opens the source. Throws InputError: it is not there or cannot be opened.
    explicit LiveFields(const ProducerSettings& settings);
    ~LiveFields();
    LiveFields(LiveFields&&) noexcept;
    LiveFields& operator=(LiveFields&&) noexcept;

    /// The next event; waits for the camera where there is one. Nothing at the end, then and ever after;
    /// error() tells which end. Never throws on bad input.
    std::optional<SensorEvent> next();

    bool ended() const;

    /// What went wrong, where, and what to do; empty before the end, and at the regular end of a file.
    const std::string& error() const;

    const ProducerSettings& settings() const;
    const InputCounts& counts() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace flownav::io
