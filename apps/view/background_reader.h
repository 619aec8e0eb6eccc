#pragma once
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "runner.h"
#include "timeline.h"

namespace flownav::view {

/// Results of a background reader since the last call.
struct BackgroundNews {
    std::vector<evaluation::FieldRow> rows;
    std::vector<MapPoint> points;
    std::vector<io::PoseSample> poses;
    std::vector<std::shared_ptr<const Checkpoint>> checkpoints;
    io::InputCounts counts;
    bool complete = false;
    io::ReadEnd end;
    std::string stop_reason;
    double progress = 0.0;
    std::string failure;  ///< why the drive cannot be shown; empty otherwise
};

/// Reads ahead through a drive and keeps a summary of every field, with checkpoints to resume from.
class BackgroundReader {
  public:
    enum class Way {
        Thread,  ///< in its own thread
        Asked,   ///< in work() only
    };

    /// `follow`: the file may still grow. Throws InputError.
    BackgroundReader(const std::filesystem::path& file, const config::Config& config, Way way, bool follow);
    ~BackgroundReader();
    BackgroundReader(const BackgroundReader&) = delete;
    BackgroundReader& operator=(const BackgroundReader&) = delete;

    /// Processes up to `fields` fields. Returns false when there are no more.
    bool work(std::size_t fields);

    BackgroundNews take();

    /// Sets the number of fields between checkpoints from now on.
    void set_stride(std::size_t fields) { stride_ = fields; }

  private:
    void run();
    bool advance();
    void publish_field();
    void publish_end();

    Runner runner_;
    bool follow_;
    std::atomic<std::size_t> stride_{8};
    std::mutex mutex_;  ///< protects news_ and the end
    BackgroundNews news_;
    std::condition_variable wake_;
    bool leave_ = false;
    std::thread thread_;
};

}  // namespace flownav::view
