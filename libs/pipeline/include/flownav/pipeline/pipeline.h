#pragma once
#include <memory>
#include <optional>

#include "flownav/core/field.h"
#include "flownav/core/readings.h"
#include "flownav/flow/matcher.h"
#include "flownav/pipeline/motion_history.h"
#include "flownav/pipeline/params.h"
#include "flownav/pipeline/step.h"

namespace flownav::pipeline {

/// The memory of the pipeline between fields: the reference, the newest field, the block layout, the rates
/// for the next prediction, the measurements of the running cycle, and the record of the last step. Movable;
/// copied by clone() only.
class State {
  public:
    /// With the registered matcher that `params.flow.matcher` names. Throws std::invalid_argument: no such
    /// one.
    explicit State(const Params& params);
    State(const Params& params, flow::Matcher matcher);  ///< `params.flow.matcher` is ignored
    ~State();
    State(State&&) noexcept;
    State& operator=(State&&) noexcept;

    /// Returns an independent copy. Shares the pixels of the held fields, which are never changed.
    State clone() const;

    /// The record of the last step.
    const Step& last_step() const;

    /// Motion of the robot between two times of the last seconds, not later than the last field; the second
    /// may be before the first. By the flow odometry; by the wheels where a part of that was carried over.
    /// Empty when neither reaches from one time to the other.
    std::optional<MotionBetween> motion_between(double from_s, double to_s) const;

  private:
    class Impl;
    friend void note_wheels(State& state, const WheelPose& reading);
    friend void note_gyro(State& state, const GyroRate& reading);
    friend const Step& step(State& state, const Field& field);

    std::unique_ptr<Impl> impl_;
};

/// Takes a reading of the wheels or of a gyro, before the field that it belongs to; a field needs the
/// readings up to its time, better also the next one. Optional: Params::other_sensors tells what they are
/// used for. A reading that is not finite, or not later than the last of its kind, is left out.
void note_wheels(State& state, const WheelPose& reading);
void note_gyro(State& state, const GyroRate& reading);

/// Processes one field: field -> flow -> ego-motion -> obstacles. Returns the record, which lives in the
/// state and is valid until the next call; its vectors are reused, so that no field allocates in steady
/// state. Does not throw on a field that cannot be used, such as one whose time stamp does not rise or whose
/// image is not as large as its camera says: its status is BadField, Step::fault has the reason, Step::faults
/// counts.
const Step& step(State& state, const Field& field);

/// Name of the block matching kernel in use.
const char* kernel_name();

}  // namespace flownav::pipeline
