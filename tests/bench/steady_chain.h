#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "flownav/pipeline/pipeline.h"

namespace flownav::bench {

/// The chain over the same drive again and again. Every drive begins so long after the last that it is a new
/// one, with all memory in place. Each field is first written to one of a few buffers, as by a camera or a
/// decoder, which is not timed.
class SteadyChain {
  public:
    SteadyChain(const std::vector<Field>& fields, const flow::KernelEntry& kernel, int threads);
    SteadyChain(const SteadyChain&) = delete;
    SteadyChain& operator=(const SteadyChain&) = delete;

    /// Seconds for timed_fields() fields, with what `see` does: without the first ones, in which the motion
    /// is still searched for.
    double drive(const std::function<void(const pipeline::Step&)>& see);
    std::size_t timed_fields() const;

    /// How many of the timed fields were understood, since the chain was made.
    double ok_share() const {
        return driven_ > 0 ? static_cast<double>(ok_) / static_cast<double>(driven_) : 0.0;
    }

    /// Mean of the timed fields: spent in the matcher, brightness and sub-pixel included.
    double match_s() const { return driven_ > 0 ? match_s_ / static_cast<double>(driven_) : 0.0; }

  private:
    using Buffer = std::vector<std::uint8_t>;

    flow::Matcher timed(flow::Matcher matcher);
    Field written(const Field& field);

    std::vector<Field> fields_;
    std::vector<std::shared_ptr<Buffer>> buffers_;
    double later_s_ = 0.0;  ///< of the running drive than the first
    bool counts_ = false;
    double match_s_ = 0.0;
    std::size_t driven_ = 0, ok_ = 0;
    pipeline::State state_;
};

}  // namespace flownav::bench
