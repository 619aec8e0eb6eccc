#pragma once
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

namespace flownav::io {

/// Passes elements from a producer thread to a consumer thread in order; holds at most `capacity` elements.
template <typename T>
class BoundedQueue {
  public:
    explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

    /// Waits for a free place and appends the element. False, without appending, when the consumer has
    /// stopped.
    bool push(T thing) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return things_.size() < capacity_ || stopped_; });
        if (stopped_) return false;
        things_.push_back(std::move(thing));
        changed_.notify_all();
        return true;
    }

    /// Called by the producer after its last element. `failure`: exception that ended it; null at a regular
    /// end.
    void close(std::exception_ptr failure = nullptr) {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        failure_ = std::move(failure);
        changed_.notify_all();
    }

    /// Waits for the next element. When the producer has closed the queue and it is empty: returns an empty
    /// optional, or throws the producer's exception.
    std::optional<T> pop() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !things_.empty() || closed_; });
        if (things_.empty()) {
            if (failure_) std::rethrow_exception(failure_);
            return std::nullopt;
        }
        std::optional<T> thing(std::move(things_.front()));
        things_.pop_front();
        changed_.notify_all();
        return thing;
    }

    /// Called by the consumer when it needs no more elements; discards the waiting ones.
    void stop() {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
        things_.clear();
        changed_.notify_all();
    }

  private:
    const std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<T> things_;
    std::exception_ptr failure_;
    bool closed_ = false;
    bool stopped_ = false;
};

}  // namespace flownav::io
