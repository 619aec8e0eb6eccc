#include "reorder_window.h"

#include <algorithm>

namespace flownav {

void ReorderWindow::push(QueuedObject object, Time now) {
    bytes_ += object.bytes.size();
    const std::int64_t time = object.time_100ns;
    waiting_.emplace(time, Waiting{now, std::move(object)});
}

std::vector<QueuedObject> ReorderWindow::take_ripe(Time now) {
    const auto ripe = [&](const auto& entry) { return now - entry.second.arrival >= hold_; };
    // The latest ripe time stamp releases all earlier ones.
    const auto latest = std::find_if(waiting_.rbegin(), waiting_.rend(), ripe);
    return take_until(latest.base());
}

std::vector<QueuedObject> ReorderWindow::take_all() {
    return take_until(waiting_.end());
}

std::vector<QueuedObject> ReorderWindow::take_until(Queue::iterator end) {
    std::vector<QueuedObject> taken;
    for (auto it = waiting_.begin(); it != end; ++it) {
        if (it->first < last_taken_) ++late_;
        last_taken_ = std::max(last_taken_, it->first);
        bytes_ -= it->second.object.bytes.size();
        taken.push_back(std::move(it->second.object));
    }
    waiting_.erase(waiting_.begin(), end);
    return taken;
}

}  // namespace flownav
