#pragma once
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace flownav {

/// One observation in the queue to the disk.
struct QueuedObject {
    std::int64_t time_100ns = 0;      ///< its time stamp
    std::string label;                ///< label of its sensor
    std::vector<std::uint8_t> bytes;  ///< serialized as in a rawlog
};

/// Sorts observations of several sensors by time stamp: each waits for `hold` after its arrival, so that
/// earlier ones can overtake it. Later arrivals pass at once and are counted.
class ReorderWindow {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using Duration = std::chrono::steady_clock::duration;

    explicit ReorderWindow(Duration hold) : hold_(hold) {}

    void push(QueuedObject object, Time now);

    /// Removes the observations that have waited long enough, and all earlier ones; returns them in order.
    std::vector<QueuedObject> take_ripe(Time now);
    std::vector<QueuedObject> take_all();

    std::uint64_t bytes() const { return bytes_; }  ///< total size of the waiting objects
    std::uint64_t late() const { return late_; }    ///< number of objects placed after later ones

  private:
    struct Waiting {
        Time arrival;
        QueuedObject object;
    };
    using Queue = std::multimap<std::int64_t, Waiting>;
    std::vector<QueuedObject> take_until(Queue::iterator end);

    Duration hold_;
    Queue waiting_;
    std::int64_t last_taken_ = INT64_MIN;
    std::uint64_t bytes_ = 0;
    std::uint64_t late_ = 0;
};

}  // namespace flownav
