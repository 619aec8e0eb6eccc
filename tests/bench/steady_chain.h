#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "flownav/pipeline/pipeline.h"

namespace flownav::bench {

/// The chain over the same fields again and again. Every drive begins so long after the last that it is a new
/// one, with all memory in place.
class SteadyChain {
  public:
    SteadyChain(const std::vector<Field>& fields, const KernelEntry& kernel, int threads);
    SteadyChain(const SteadyChain&) = delete;
    SteadyChain& operator=(const SteadyChain&) = delete;

    void drive(const std::function<void(const pipeline::Step&)>& see);

    /// Spent in the matcher, brightness and sub-pixel included.
    double match_s() const { return match_s_; }
    void forget_times() { match_s_ = 0.0; }

  private:
    Matcher timed(Matcher matcher);

    std::vector<Field> fields_;
    double match_s_ = 0.0;
    pipeline::State state_;
};

}  // namespace flownav::bench
