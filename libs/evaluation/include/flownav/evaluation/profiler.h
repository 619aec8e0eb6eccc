#pragma once
#include <chrono>

#include "flownav/evaluation/timing.h"
#include "flownav/flow/matcher.h"

namespace flownav::evaluation {

/// Measures the time of each stage of a replay: time is attributed to the stage that was entered last.
class Profiler {
  public:
    using Stage = double StageTimes::*;
    static constexpr Stage other = nullptr;  ///< time of no stage

    void enter(Stage stage);

    /// Adds time that was measured elsewhere, for example in another thread.
    void credit(Stage stage, double seconds) { since_field_.*stage += seconds; }

    /// Attributes the time since the previous call to this field.
    void end_field(double timestamp_s);

    /// Wraps a matcher: its time is attributed to matching, the time after it to motion. The profiler must
    /// outlive the result.
    flow::Matcher timed(flow::Matcher matcher);

    /// Fills `timing` with the stages, fields and total time since construction.
    void report(Timing& timing);

  private:
    using Clock = std::chrono::steady_clock;

    Stage stage_ = other;
    Clock::time_point start_ = Clock::now();
    Clock::time_point entered_ = start_;
    StageTimes since_field_;
    std::vector<FieldTimes> fields_;
};

}  // namespace flownav::evaluation
