#include "flownav/nav/watchdog.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace flownav::nav {

Watchdog::Watchdog(std::function<void()> stop) : stop_(std::move(stop)), thread_([this] { watch(); }) {}

Watchdog::~Watchdog() {
    {
        const std::lock_guard lock(mutex_);
        state_ = State::Ended;
    }
    changed_.notify_all();
    thread_.join();
}

void Watchdog::start_watchdog(double period_s) {
    if (!std::isfinite(period_s) || period_s < 0.0) {
        throw std::invalid_argument("the period of the watchdog must be a number of seconds, 0 or more");
    }
    {
        const std::lock_guard lock(mutex_);
        period_ = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(period_s));
        due_ = Clock::now() + period_;
        state_ = State::Waiting;
    }
    changed_.notify_all();
}

void Watchdog::stop_watchdog() {
    {
        const std::lock_guard lock(mutex_);
        state_ = State::Off;
    }
    changed_.notify_all();
}

void Watchdog::alive() {
    {
        const std::lock_guard lock(mutex_);
        if (state_ == State::Off) return;
        due_ = Clock::now() + period_;
        state_ = State::Waiting;
    }
    changed_.notify_all();
}

void Watchdog::watch() {
    std::unique_lock lock(mutex_);
    while (state_ != State::Ended) {
        if (state_ != State::Waiting) {
            changed_.wait(lock);
        } else if (Clock::now() < due_) {
            changed_.wait_until(lock, due_);
        } else {
            state_ = State::Expired;
            lock.unlock();  // the callback may take its time, alive() must not wait for it
            stop_();
            lock.lock();
        }
    }
}

}  // namespace flownav::nav
