#pragma once
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "recording.h"
#include "reorder_window.h"

namespace flownav {

/// What became of the observations so far, by label of the sensor.
struct WriterCounts {
    std::map<std::string, std::uint64_t> written;  ///< in the kernel's hands
    std::map<std::string, std::uint64_t> dropped;  ///< the disk was too slow and the memory for waiting full
    std::uint64_t late = 0;                        ///< written, but after later ones
    std::uint64_t lost = 0;                        ///< could not be written any more
    std::uint64_t file_bytes = 0;
    std::uint64_t queue_bytes = 0;
};

/// Writes observations in a thread of its own, in the order of time, as whole gz members of a
/// twentieth of a second: what was observed is with the kernel about 0.16 s later.
class DiskWriter {
  public:
    static constexpr auto hold = std::chrono::milliseconds(100);          ///< for the order of time
    static constexpr auto member_period = std::chrono::milliseconds(50);  ///< longest wait for a flush

    /// Opens the recording. Throws OutputError.
    DiskWriter(RecordingOptions options, std::uint64_t queue_bytes_max);
    ~DiskWriter();
    DiskWriter(const DiskWriter&) = delete;
    DiskWriter& operator=(const DiskWriter&) = delete;

    /// Never waits for the disk: when no more fits into the queue, the object is dropped and counted.
    void put(QueuedObject object);

    /// The same for what need not be dropped because its source can wait.
    void put_when_there_is_room(QueuedObject object);

    /// Writes all that was put and closes the recording.
    void finish();

    WriterCounts counts() const;
    std::string failure() const;  ///< names the file; empty when all is well
    std::vector<std::filesystem::path> files() const;

  private:
    void run();
    void write_until_finished();
    void write(const std::vector<QueuedObject>& objects);
    void flush();
    bool fits(const QueuedObject& object) const;

    const std::uint64_t queue_bytes_max_;
    const std::uint64_t member_bytes_max_;  ///< uncompressed
    Recording recording_;                   ///< of the writing thread
    std::map<std::string, std::uint64_t> in_member_;
    std::chrono::steady_clock::time_point member_begin_;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::condition_variable room_;
    ReorderWindow window_{hold};
    WriterCounts counts_;
    std::vector<std::filesystem::path> files_;
    std::uint64_t taken_ = 0;  ///< out of the window
    std::string failure_;
    bool finishing_ = false;
    std::thread thread_;
};

}  // namespace flownav
