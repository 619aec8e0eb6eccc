#pragma once
#include <chrono>

#include "flownav/evaluation/timing.h"
#include "flownav/flow/matcher.h"

namespace flownav::evaluation {

/// Tells where the time of a replay goes: every moment belongs to the stage that was entered last.
class Profiler {
  public:
    using Stage = double StageTimes::*;
    static constexpr Stage other = nullptr;  ///< what no stage accounts for

    void enter(Stage stage);

    /// Time that was measured elsewhere, perhaps in another thread.
    void credit(Stage stage, double seconds) { since_field_.*stage += seconds; }

    /// What was spent since the last field belongs to this one.
    void end_field(double timestamp_s);

    /// A matcher whose time counts as matching, and what follows as motion. The clock must outlive it.
    flow::Matcher timed(flow::Matcher matcher);

    /// Everything since the clock was made.
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
