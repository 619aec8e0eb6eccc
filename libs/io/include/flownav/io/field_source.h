#pragma once
#include <optional>

#include "flownav/io/event_maker.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::io {

/// A field or a pose of a rawlog.
using ReplayEvent = SensorEvent;

/// Fields and poses of a rawlog, in the order of the file, converted by an EventMaker.
class FieldSource {
  public:
    FieldSource(RawlogReader& reader, const config::CameraConfig& camera) : reader_(reader), maker_(camera) {}

    /// Continues in the state of another source whose reader stood where `reader` stands now; `like` may have
    /// reached its end.
    FieldSource(RawlogReader& reader, const FieldSource& like) : reader_(reader), maker_(like.maker_) {}

    /// Next event; empty at the end of the rawlog. Times rise strictly within each kind of event. Throws
    /// ConfigError: an image without calibration (names the keys to set), or an unusable camera pose (height
    /// not positive, looking up, roll or yaw over 10 degrees).
    std::optional<ReplayEvent> next();

    const InputCounts& counts() const { return maker_.counts(); }

  private:
    RawlogReader& reader_;
    EventMaker maker_;
    bool finished_ = false;
};

}  // namespace flownav::io
