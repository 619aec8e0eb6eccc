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

/// A live source as a rawlog that grows: its fields and odometry go to a temporary file, plain and flushed
/// object by object, for a viewer that follows it. The file is gone with this.
class LiveRecorder {
  public:
    /// Opens the source and waits for its first field. Throws ConfigError, InputError, OutputError.
    explicit LiveRecorder(const std::string& ini_file);
    ~LiveRecorder();
    LiveRecorder(const LiveRecorder&) = delete;
    LiveRecorder& operator=(const LiveRecorder&) = delete;

    const std::filesystem::path& file() const { return file_; }

    /// For reading the file: calibration and fields are already as they shall be.
    config::Config config() const;

    /// What is looked at, for people.
    const std::string& source() const { return fields_.settings().source; }

    /// Why no more comes, for people; empty while the source runs.
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
    mutable std::mutex mutex_;  ///< of problem_
    std::string problem_;
    std::thread thread_;
};

}  // namespace flownav::view
