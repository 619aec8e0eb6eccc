#pragma once
#include <memory>

#include "flownav/core/field.h"
#include "flownav/flow/matcher.h"
#include "flownav/pipeline/params.h"
#include "flownav/pipeline/step.h"

namespace flownav::pipeline {

/// Everything that outlives a field: the held fields, the block layout, the rates for the next prediction,
/// the measurements of the running cycle, and the record of the last step. Movable; copied by clone() only.
class State {
  public:
    explicit State(const Params& params);
    State(const Params& params, flow::Matcher matcher);  ///< with vectors from elsewhere
    ~State();
    State(State&&) noexcept;
    State& operator=(State&&) noexcept;

    /// A state that goes on from here by itself. Shares the pixels of the held fields, which nobody changes.
    State clone() const;

    /// The record of the last step.
    const Step& last_step() const;

    struct Impl;
    Impl& impl() { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

/// The sentence: field -> flow -> ego-motion -> obstacles. The record lives in the state and is valid until
/// the next call; its vectors are reused, so that nothing is allocated in steady state. Never throws on a
/// field that cannot be used, such as one whose time stamp does not rise or whose image is not as large as
/// its camera says: its status is BadField, Step::fault says why, Step::faults counts.
const Step& step(State& state, const Field& field);

/// Name of the block matching kernel in use.
const char* kernel_name();

}  // namespace flownav::pipeline
