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

/// What a background reader has found since it was asked last.
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
    std::string failure;  ///< why nothing at all can be shown; empty otherwise
};

/// Runs ahead through a drive and takes down a little of every field, with checkpoints to come back to.
class BackgroundReader {
  public:
    enum class Way {
        Thread,  ///< by itself, in the background
        Asked,   ///< only in work()
    };

    /// `follow`: the file may still grow. Throws InputError.
    BackgroundReader(const std::filesystem::path& file, const config::Config& config, Way way, bool follow);
    ~BackgroundReader();
    BackgroundReader(const BackgroundReader&) = delete;
    BackgroundReader& operator=(const BackgroundReader&) = delete;

    /// Processes up to `fields` fields; false when there are no more.
    bool work(std::size_t fields);

    BackgroundNews take();

    /// A checkpoint every so many fields from now on.
    void set_stride(std::size_t fields) { stride_ = fields; }

  private:
    void run();
    bool advance();
    void publish_field();
    void publish_end();

    Runner runner_;
    bool follow_;
    std::atomic<std::size_t> stride_{8};
    std::mutex mutex_;  ///< of news_ and of the end
    BackgroundNews news_;
    std::condition_variable wake_;
    bool leave_ = false;
    std::thread thread_;
};

}  // namespace flownav::view
