#include "flownav/replay/realtime_replay.h"

#include <algorithm>
#include <stdexcept>

namespace flownav::replay {

RepeatedTimes::RepeatedTimes(const std::vector<double>& recorded_s) {
    if (recorded_s.size() < 2) throw std::invalid_argument("a paced run needs two fields or more");
    if (recorded_s.back() <= recorded_s.front())
        throw std::invalid_argument("the fields of a paced run must follow each other in time");
    for (const double time_s : recorded_s) after_first_s_.push_back(time_s - recorded_s.front());
    once_s_ = after_first_s_.back() * static_cast<double>(recorded_s.size()) /
              static_cast<double>(recorded_s.size() - 1);
}

double RepeatedTimes::after_start_s(std::uint64_t n) const {
    const std::uint64_t played_before = n / after_first_s_.size();
    return static_cast<double>(played_before) * once_s_ + after_first_s_[field(n)];
}

std::uint64_t RepeatedTimes::count_within(double duration_s) const {
    std::uint64_t count = 1;
    while (after_start_s(count) < duration_s) ++count;
    return count;
}

PacedFields replay_paced(const RepeatedTimes& times, std::uint64_t count, const PaceClock& clock,
                         const std::function<void(std::uint64_t n)>& work) {
    PacedFields fields;
    fields.arrived = count;
    fields.latencies_s.reserve(count);  // avoids allocations between fields
    const double start_s = clock.now_s();
    for (std::uint64_t n = 0; n < count; ++n) {
        const double now_s = clock.now_s() - start_s;
        while (n + 1 < count && times.after_start_s(n + 1) <= now_s) {
            ++n;
            ++fields.dropped;
        }
        const double arrival_s = times.after_start_s(n);
        if (arrival_s > now_s) clock.wait_until_s(start_s + arrival_s);
        work(n);
        fields.latencies_s.push_back(clock.now_s() - start_s - arrival_s);
    }
    return fields;
}

LatencyFigures latency_figures(std::vector<double> samples_s) {
    if (samples_s.empty()) return {};
    std::sort(samples_s.begin(), samples_s.end());
    const auto rank = [&samples_s](std::size_t per_mille) {
        return samples_s[(samples_s.size() * per_mille + 999) / 1000 - 1];
    };
    return {rank(500), rank(990), rank(999), samples_s.back()};
}

}  // namespace flownav::replay
