#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace flownav::replay {

/// Times of the fields of a recording that is played repeatedly: the first field follows one mean period
/// after the last.
class RepeatedTimes {
  public:
    /// `recorded_s`: rising times in seconds. Throws std::invalid_argument when there are fewer than two, or
    /// the last is not later than the first.
    explicit RepeatedTimes(const std::vector<double>& recorded_s);

    std::size_t field(std::uint64_t n) const { return n % after_first_s_.size(); }  ///< recorded index
    double after_start_s(std::uint64_t n) const;
    std::uint64_t count_within(double duration_s) const;  ///< fields before `duration_s`, at least one
    double once_s() const { return once_s_; }             ///< duration, last period included

  private:
    std::vector<double> after_first_s_;
    double once_s_ = 0.0;
};

/// Clock of a paced run. Both functions use seconds of the same steady clock.
struct PaceClock {
    std::function<double()> now_s;
    std::function<void(double time_s)> wait_until_s;
};

struct PacedFields {
    std::uint64_t arrived = 0;
    std::uint64_t dropped = 0;        ///< replaced by a newer field before the chain was free
    std::vector<double> latencies_s;  ///< of the other fields, from arrival to the end of the work
};

/// Calls `work` with each of the first `count` fields at its time. At most one field waits while the work is
/// busy; a newer field replaces it, and the older one is dropped.
PacedFields replay_paced(const RepeatedTimes& times, std::uint64_t count, const PaceClock& clock,
                         const std::function<void(std::uint64_t n)>& work);

struct LatencyFigures {
    double median_s = 0.0;
    double p99_s = 0.0;
    double p999_s = 0.0;
    double worst_s = 0.0;
};

/// Quantiles of the samples by nearest rank; zeros when there are no samples.
LatencyFigures latency_figures(std::vector<double> samples_s);

}  // namespace flownav::replay
