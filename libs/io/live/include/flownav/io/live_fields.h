#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "flownav/io/event_maker.h"
#include "flownav/io/producer_settings.h"

namespace flownav::io {

/// Fields and poses of a source of CFlowObstacleSensor: a camera, a stream, a video, a folder of images or a
/// rawlog.
class LiveFields {
  public:
    /// Opens the source. Throws InputError when it is missing or cannot be opened.
    explicit LiveFields(const ProducerSettings& settings);
    ~LiveFields();
    LiveFields(LiveFields&&) noexcept;
    LiveFields& operator=(LiveFields&&) noexcept;

    /// Next event; waits for a camera's image. Empty at and after the end, when error() holds its reason.
    /// Never throws on bad input.
    std::optional<SensorEvent> next();

    bool ended() const;

    /// Failure, place and advice; empty before the end, and at the regular end of a file.
    const std::string& error() const;

    /// What was recognised or mended in the source so far, one sentence each; complete at the end.
    std::vector<std::string> notes() const;

    const ProducerSettings& settings() const;
    const InputCounts& counts() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace flownav::io
