#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "runner.h"

namespace flownav::view {

/// Checkpoints of a drive, spread evenly, in bounded memory: when there are too many, every second one goes.
class Checkpoints {
  public:
    explicit Checkpoints(std::size_t bytes_max) : bytes_max_(bytes_max) {}

    /// In rising order of next_index.
    void add(std::shared_ptr<const Checkpoint> checkpoint);

    /// The last one from which the field `index` lies ahead; null when there is none.
    std::shared_ptr<const Checkpoint> before(std::size_t index) const;

    bool empty() const { return kept_.empty(); }
    std::size_t size() const { return kept_.size(); }
    std::size_t bytes() const { return bytes_; }
    std::size_t stride() const { return stride_; }  ///< fields from one to the next that is worth adding

  private:
    void thin();

    std::vector<std::shared_ptr<const Checkpoint>> kept_;
    std::size_t bytes_max_;
    std::size_t bytes_ = 0;
    std::size_t stride_ = 8;
};

}  // namespace flownav::view
