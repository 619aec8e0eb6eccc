#pragma once
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "flownav/io/live_fields.h"

namespace flownav::view {

/// Records the fields and odometry of a live source to a temporary rawlog, uncompressed and flushed per
/// object, so that a viewer can follow it. Removes the file in its destructor.
class LiveRecorder {
  public:
    /// Opens the source and waits for its first field. Throws ConfigError, InputError, OutputError.
    explicit LiveRecorder(const std::string& ini_file);
    ~LiveRecorder();
    LiveRecorder(const LiveRecorder&) = delete;
    LiveRecorder& operator=(const LiveRecorder&) = delete;

    const std::filesystem::path& file() const { return file_; }

    /// Configuration for reading the file, whose images are calibrated and split into fields already.
    config::Config config() const;

    /// Name of the source, for messages.
    const std::string& source() const { return fields_.settings().source; }

    /// Why the source ended, for messages; empty while it runs.
    std::string problem() const;

  private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    bool copy_next();
    void write(const mrpt::obs::CObservation& observation);
    void run();
    void stop(const std::string& problem);

    io::LiveFields fields_;
    std::filesystem::path file_;
    std::unique_ptr<std::FILE, Closer> stream_;
    bool any_field_ = false;
    std::atomic<bool> leave_{false};
    mutable std::mutex mutex_;  ///< protects problem_
    std::string problem_;
    std::thread thread_;
};

}  // namespace flownav::view
