#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace flownav::replay {

/// When the fields of a recording come, played over and over: after the last one, and a mean period, the
/// first one comes again.
class RepeatedTimes {
  public:
    /// Rising times; throws std::invalid_argument when there are less than two, or the last is no later than
    /// the first.
    explicit RepeatedTimes(const std::vector<double>& recorded_s);

    std::size_t field(std::uint64_t n) const { return n % after_first_s_.size(); }  ///< of the recording
    double after_start_s(std::uint64_t n) const;
    std::uint64_t count_within(double duration_s) const;  ///< how many come before `duration_s`, at least one
    double once_s() const { return once_s_; }             ///< how long the recording takes, period included

  private:
    std::vector<double> after_first_s_;
    double once_s_ = 0.0;
};

/// Where a paced run takes its time from. Seconds of the same steady clock.
struct PaceClock {
    std::function<double()> now_s;
    std::function<void(double time_s)> wait_until_s;
};

struct PacedFields {
    std::uint64_t arrived = 0;
    std::uint64_t dropped = 0;        ///< a newer one had come before the chain was free
    std::vector<double> latencies_s;  ///< of the others, from arrival until the work was done
};

/// Calls `work` with each of the first `count` fields as it comes. While the work is busy at most one field
/// waits: a newer one takes its place, and the older one is dropped.
PacedFields replay_paced(const RepeatedTimes& times, std::uint64_t count, const PaceClock& clock,
                         const std::function<void(std::uint64_t n)>& work);

struct LatencyFigures {
    double median_s = 0.0;
    double p99_s = 0.0;
    double p999_s = 0.0;
    double worst_s = 0.0;
};

/// Each the smallest sample that its share of all samples does not exceed (nearest rank); zeros of nothing.
LatencyFigures latency_figures(std::vector<double> samples_s);

}  // namespace flownav::replay
