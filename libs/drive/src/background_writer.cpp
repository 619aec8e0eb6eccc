#include "background_writer.h"

#include <utility>

namespace flownav::drive {

BackgroundWriter::BackgroundWriter() : thread_([this] { run(); }) {}

BackgroundWriter::~BackgroundWriter() {
    end();
}

void BackgroundWriter::push(Job job) {
    {
        const std::lock_guard lock(mutex_);
        jobs_.push_back(std::move(job));
    }
    changed_.notify_all();
}

bool BackgroundWriter::push_if_fewer(Job job, std::size_t most) {
    {
        const std::lock_guard lock(mutex_);
        if (jobs_.size() >= most) return false;
        jobs_.push_back(std::move(job));
    }
    changed_.notify_all();
    return true;
}

void BackgroundWriter::push_when_fewer(Job job, std::size_t most) {
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return jobs_.size() < most; });
        jobs_.push_back(std::move(job));
    }
    changed_.notify_all();
}

void BackgroundWriter::finish() {
    end();
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void BackgroundWriter::end() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void BackgroundWriter::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return ends_ || !jobs_.empty(); });
        if (jobs_.empty()) return;
        const Job job = std::move(jobs_.front());
        jobs_.pop_front();
        if (!failure_) {
            lock.unlock();
            try {
                job();
                lock.lock();
            } catch (...) {
                lock.lock();
                failure_ = std::current_exception();
            }
        }
        changed_.notify_all();
    }
}

}  // namespace flownav::drive
