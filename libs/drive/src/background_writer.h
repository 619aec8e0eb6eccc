#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace flownav::drive {

/// Does one job after the other in a thread of its own. After a job that throws, the others are dropped.
class BackgroundWriter {
  public:
    using Job = std::function<void()>;

    BackgroundWriter();
    /// Does what still waits.
    ~BackgroundWriter();
    BackgroundWriter(const BackgroundWriter&) = delete;
    BackgroundWriter& operator=(const BackgroundWriter&) = delete;

    /// Adds a job.
    void push(Job job);
    /// Adds a job unless `most` are waiting; false: it was not added.
    bool push_if_fewer(Job job, std::size_t most);
    /// Adds a job when fewer than `most` are waiting, and waits until then.
    void push_when_fewer(Job job, std::size_t most);

    /// Does what still waits and ends the thread. Throws what a job threw.
    void finish();

  private:
    void run();
    void end();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    std::exception_ptr failure_;
    bool ends_ = false;
    std::thread thread_;  ///< last: starts when all else is there
};

}  // namespace flownav::drive
