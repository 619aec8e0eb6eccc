#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace flownav {

/// First-in, first-out queue that reuses popped elements with the memory they hold: it allocates only while
/// it grows beyond its largest size so far.
template <typename T>
class RecyclingQueue {
  public:
    bool empty() const { return count_ == 0; }
    std::size_t size() const { return count_; }
    T& front() { return places_[oldest_]; }

    /// Returns the new back element; its content is unspecified.
    T& push() {
        if (count_ == places_.size()) {
            std::rotate(places_.begin(), places_.begin() + static_cast<std::ptrdiff_t>(oldest_),
                        places_.end());
            oldest_ = 0;
            places_.emplace_back();
        }
        return places_[(oldest_ + count_++) % places_.size()];
    }

    void pop() {
        oldest_ = (oldest_ + 1) % places_.size();
        --count_;
    }

  private:
    std::vector<T> places_;
    std::size_t oldest_ = 0;
    std::size_t count_ = 0;
};

}  // namespace flownav
