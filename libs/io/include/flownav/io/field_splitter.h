#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/field.h"

namespace flownav::io {

/// Returns the top or bottom field of a woven frame: a view of every second line, with the field's camera.
Field field_of_frame(const Field& frame, bool bottom);

/// Splits woven frames into their fields; the second one lies half a frame period after the first. The period
/// is the median of the latest intervals, so that a dropped or early frame does not displace the fields. The
/// second field is returned with the next frame, when the interval is known. Frames that are not woven pass
/// unchanged.
class FieldSplitter {
  public:
    explicit FieldSplitter(config::Interlaced interlaced) : interlaced_(interlaced) {}

    /// Returns the fields completed by this frame; times must rise.
    std::vector<Field> push(const Field& frame);

    /// Returns the second field of the last frame, if any. Uses PAL's period when there was only one frame.
    std::vector<Field> finish();

  private:
    Field second_field(double period_s);

    config::Interlaced interlaced_;
    std::optional<Field> second_;     ///< second field of the last frame, with the frame's time
    std::deque<double> intervals_s_;  ///< the latest intervals between frames
};

}  // namespace flownav::io
