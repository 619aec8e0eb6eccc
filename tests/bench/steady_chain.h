#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "flownav/pipeline/pipeline.h"

namespace flownav::bench {

/// Runs the chain repeatedly over the same drive, with all memory allocated. A long gap in the time stamps
/// makes every run a new drive. Each field is first written to one of a few buffers, as by a camera or a
/// decoder; this is not timed.
class SteadyChain {
  public:
    SteadyChain(const std::vector<Field>& fields, const flow::KernelEntry& kernel, int threads);
    SteadyChain(const SteadyChain&) = delete;
    SteadyChain& operator=(const SteadyChain&) = delete;

    /// Runs one drive and returns the seconds for timed_fields() fields, including `see`. The first fields,
    /// in which the motion is searched for, are not timed.
    double drive(const std::function<void(const pipeline::Step&)>& see);
    std::size_t timed_fields() const;

    /// Share of the timed fields with status ok, over all drives.
    double ok_share() const {
        return driven_ > 0 ? static_cast<double>(ok_) / static_cast<double>(driven_) : 0.0;
    }

    /// Mean time per timed field in the matcher, including brightness and sub-pixel.
    double match_s() const { return driven_ > 0 ? match_s_ / static_cast<double>(driven_) : 0.0; }

  private:
    using Buffer = std::vector<std::uint8_t>;

    flow::Matcher timed(flow::Matcher matcher);
    Field written(const Field& field);

    std::vector<Field> fields_;
    std::vector<std::shared_ptr<Buffer>> buffers_;
    double later_s_ = 0.0;  ///< offset of the time stamps of the running drive
    bool counts_ = false;
    double match_s_ = 0.0;
    std::size_t driven_ = 0, ok_ = 0;
    pipeline::State state_;
};

}  // namespace flownav::bench
