#pragma once
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace flownav {

/// One observation on its way to the disk.
struct QueuedObject {
    std::int64_t time_100ns = 0;      ///< its time stamp
    std::string label;                ///< of its sensor
    std::vector<std::uint8_t> bytes;  ///< as a rawlog has it
};

/// Puts observations of several sensors in the order of their time stamps: each waits for `hold` after its
/// arrival, so that earlier ones can overtake it. What comes later than that is let through at once and
/// counted.
class ReorderWindow {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using Duration = std::chrono::steady_clock::duration;

    explicit ReorderWindow(Duration hold) : hold_(hold) {}

    void push(QueuedObject object, Time now);

    /// What has waited long enough, and all that is earlier; in order.
    std::vector<QueuedObject> take_ripe(Time now);
    std::vector<QueuedObject> take_all();

    std::uint64_t bytes() const { return bytes_; }  ///< of what is waiting
    std::uint64_t late() const { return late_; }    ///< objects that stand after later ones

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
