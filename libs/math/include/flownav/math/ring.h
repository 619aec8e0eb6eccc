#pragma once
#include <array>
#include <cstddef>

namespace flownav {

/// The newest N values, the oldest first. Allocates no memory.
template <typename T, std::size_t N>
class Ring {
  public:
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    void clear() { size_ = 0; }

    /// Appends a value; the oldest one goes when there are N already.
    void push(const T& value) {
        values_[(begin_ + size_) % N] = value;
        if (size_ < N) {
            ++size_;
        } else {
            begin_ = (begin_ + 1) % N;
        }
    }

    const T& operator[](std::size_t i) const { return values_[(begin_ + i) % N]; }
    const T& front() const { return (*this)[0]; }
    const T& back() const { return (*this)[size_ - 1]; }

    /// Index of the first value for which `is_before` is false; size() when there is none. The values for
    /// which it is true come first.
    template <typename IsBefore>
    std::size_t partition_point(const IsBefore& is_before) const {
        std::size_t low = 0;
        std::size_t high = size_;
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            if (is_before((*this)[middle])) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

  private:
    std::array<T, N> values_{};
    std::size_t begin_ = 0;
    std::size_t size_ = 0;
};

}  // namespace flownav
