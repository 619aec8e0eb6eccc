#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/field.h"

namespace flownav::io {

/// Every second line of a woven frame as a field of its own (a view), with the camera of those lines.
Field field_of_frame(const Field& frame, bool bottom);

/// Splits woven frames into their fields, the second one half a frame period after the first. The period is
/// the median of the latest intervals, so that a dropped or an early frame does not displace the fields; it
/// is known only with the frame after, and the second field waits for that. Frames that are not woven pass
/// unchanged.
class FieldSplitter {
  public:
    explicit FieldSplitter(config::Interlaced interlaced) : interlaced_(interlaced) {}

    /// The fields that became complete with this frame; times must rise.
    std::vector<Field> push(const Field& frame);

    /// The field that still waits after the last frame; PAL's period when there was one frame only.
    std::vector<Field> finish();

  private:
    Field second_field(double period_s);

    config::Interlaced interlaced_;
    std::optional<Field> second_;     ///< with its frame's time
    std::deque<double> intervals_s_;  ///< the latest intervals between frames
};

}  // namespace flownav::io
