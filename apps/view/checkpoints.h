#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "runner.h"

namespace flownav::view {

/// Evenly spaced checkpoints of a drive in bounded memory: above the limit, every second one is dropped.
class Checkpoints {
  public:
    explicit Checkpoints(std::size_t bytes_max) : bytes_max_(bytes_max) {}

    /// Adds a checkpoint; next_index must rise.
    void add(std::shared_ptr<const Checkpoint> checkpoint);

    /// Returns the last checkpoint from which field `index` lies ahead; null when there is none.
    std::shared_ptr<const Checkpoint> before(std::size_t index) const;

    bool empty() const { return kept_.empty(); }
    std::size_t size() const { return kept_.size(); }
    std::size_t bytes() const { return bytes_; }
    std::size_t stride() const { return stride_; }  ///< minimum number of fields between checkpoints

  private:
    void thin();

    std::vector<std::shared_ptr<const Checkpoint>> kept_;
    std::size_t bytes_max_;
    std::size_t bytes_ = 0;
    std::size_t stride_ = 8;
};

}  // namespace flownav::view
