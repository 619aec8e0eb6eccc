#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace flownav::drive {

/// Runs jobs in order in its own thread. After a job that throws, all later jobs are dropped.
class BackgroundWriter {
  public:
    using Job = std::function<void()>;

    BackgroundWriter();
    /// Runs the waiting jobs, then ends the thread.
    ~BackgroundWriter();
    BackgroundWriter(const BackgroundWriter&) = delete;
    BackgroundWriter& operator=(const BackgroundWriter&) = delete;

    /// Adds a job.
    void push(Job job);
    /// Adds a job unless `most` are waiting. Returns false when it was not added.
    bool push_if_fewer(Job job, std::size_t most);
    /// Waits until fewer than `most` jobs are waiting, then adds the job.
    void push_when_fewer(Job job, std::size_t most);

    /// Runs the waiting jobs and ends the thread. Rethrows the first exception of a job.
    void finish();

  private:
    void run();
    void end();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    std::exception_ptr failure_;
    bool ends_ = false;
    std::thread thread_;  ///< last: starts when all other members exist
};

}  // namespace flownav::drive
