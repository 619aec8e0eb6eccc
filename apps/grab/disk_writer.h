#pragma once
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "recording.h"
#include "reorder_window.h"

namespace flownav {

/// Counts of observations by label of the sensor.
struct WriterCounts {
    std::map<std::string, std::uint64_t> written;  ///< passed to the kernel
    /// Dropped because the disk was too slow and the queue full.
    std::map<std::string, std::uint64_t> dropped;
    std::uint64_t late = 0;  ///< written after later ones
    std::uint64_t lost = 0;  ///< lost to a failed disk
    std::uint64_t file_bytes = 0;
    std::uint64_t queue_bytes = 0;
};

/// Writes observations in its own thread, in order of time, as whole gz members of 50 ms each: an observation
/// reaches the kernel about 0.16 s later.
class DiskWriter {
  public:
    static constexpr auto hold = std::chrono::milliseconds(100);          ///< delay for sorting by time
    static constexpr auto member_period = std::chrono::milliseconds(50);  ///< longest wait for a flush

    /// Opens the recording. Throws OutputError.
    DiskWriter(RecordingOptions options, std::uint64_t queue_bytes_max);
    ~DiskWriter();
    DiskWriter(const DiskWriter&) = delete;
    DiskWriter& operator=(const DiskWriter&) = delete;

    /// Queues an object. Never waits for the disk: when the queue is full, the object is dropped and counted.
    void put(QueuedObject object);

    /// Queues an object of a source that can wait; waits for room in the queue.
    void put_when_there_is_room(QueuedObject object);

    /// Writes all queued objects and closes the recording.
    void finish();

    WriterCounts counts() const;
    std::string failure() const;  ///< names the file; empty without a failure
    std::vector<std::filesystem::path> files() const;

  private:
    void run();
    void write_until_finished();
    void write(const std::vector<QueuedObject>& objects);
    void flush();
    bool fits(const QueuedObject& object) const;

    const std::uint64_t queue_bytes_max_;
    const std::uint64_t member_bytes_max_;  ///< uncompressed
    Recording recording_;                   ///< used by the writing thread only
    std::map<std::string, std::uint64_t> in_member_;
    std::chrono::steady_clock::time_point member_begin_;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::condition_variable room_;
    ReorderWindow window_{hold};
    WriterCounts counts_;
    std::vector<std::filesystem::path> files_;
    std::uint64_t taken_ = 0;  ///< removed from the window
    std::string failure_;
    bool finishing_ = false;
    std::thread thread_;
};

}  // namespace flownav
