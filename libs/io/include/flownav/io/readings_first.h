#pragma once
#include <deque>
#include <optional>

#include "flownav/io/event_maker.h"

namespace flownav::io {

/// Orders the events of a recording: a field waits for the first reading of wheels and gyro after it, so that
/// its motion can be interpolated. It waits only for a kind of reading that came until shortly before it, and
/// behind three other fields at the most. All other events keep their order.
class ReadingsFirst {
  public:
    void push(const SensorEvent& event);

    /// No more events come: no field waits any longer.
    void flush();

    /// Next event; empty when more events are needed.
    std::optional<SensorEvent> pop();

  private:
    bool must_wait(const Field& field) const;
    void release();

    std::deque<SensorEvent> ready_;
    std::deque<Field> waiting_;
    std::optional<double> wheels_s_;  ///< time of the newest reading
    std::optional<double> gyro_s_;
};

}  // namespace flownav::io
