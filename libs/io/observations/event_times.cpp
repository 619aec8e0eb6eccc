#include "flownav/io/event_times.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flownav::io {
namespace {

constexpr double first_allowed_s = 0.0;          // 1970
constexpr double last_allowed_s = 4102444800.0;  // 2100
constexpr std::size_t start_events = 5;          // of a kind are looked at before the first is used
constexpr std::size_t agreeing_events = 3;       // after a jump of the clock show that it goes on from there
constexpr std::size_t intervals_kept = 11;
constexpr std::size_t intervals_min = 4;
constexpr std::size_t held_fields_max = 12;  // bounds the memory
constexpr std::size_t held_max = 4096;
// Shares of the usual interval.
constexpr double too_close_share = 0.15;
constexpr double irregular_share = 0.4;
constexpr double long_share = 1.5;
constexpr double jump_share = 20.0;
constexpr double on_beat_share = 0.15;
constexpr double off_beat_share = 0.3;
constexpr double steady_share = 0.8;  // of the intervals must be on the beat
constexpr double jump_min_s = 2.0;
constexpr double same_shift_s =
    0.5;  // clocks of two kinds that were set by nearly the same were set together

/// The value below which a share of the intervals lies; 0 when there are too few.
double quantile_s(const std::deque<double>& intervals_s, double share) {
    if (intervals_s.size() < intervals_min) return 0.0;
    std::vector<double> sorted(intervals_s.begin(), intervals_s.end());
    const auto at =
        sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return *at;
}

/// The upper quartile, which dropped events and pairs of stamps hardly change.
double usual_s(const std::deque<double>& intervals_s) {
    return quantile_s(intervals_s, 0.75);
}

bool is_jump(const std::deque<double>& intervals_s, double interval_s) {
    return interval_s > std::max(jump_min_s, jump_share * usual_s(intervals_s));
}

bool is_long(const std::deque<double>& intervals_s, double interval_s) {
    const double usual = usual_s(intervals_s);
    return usual > 0.0 && interval_s > long_share * usual;
}

bool is_too_close(const std::deque<double>& intervals_s, EventKind kind, double interval_s) {
    return kind == EventKind::Image && interval_s < too_close_share * usual_s(intervals_s);
}

/// Distance of an interval from the nearest multiple of the beat, in beats.
double off_beat(double interval_s, double beat_s) {
    const double beats = interval_s / beat_s;
    return std::abs(beats - std::max(1.0, std::round(beats)));
}

/// The beat of a camera that misses images now and then, but is else regular; 0 of any other.
double beat_s(const std::deque<double>& intervals_s) {
    const double beat = quantile_s(intervals_s, 0.25);
    if (beat <= 0.0) return 0.0;
    const auto is_on = [beat](double interval_s) { return off_beat(interval_s, beat) < on_beat_share; };
    const auto on = std::count_if(intervals_s.begin(), intervals_s.end(), is_on);
    return static_cast<double>(on) >= steady_share * static_cast<double>(intervals_s.size()) ? beat : 0.0;
}

bool is_off_beat(const std::deque<double>& intervals_s, EventKind kind, double interval_s) {
    const double beat = kind == EventKind::Image ? beat_s(intervals_s) : 0.0;
    return beat > 0.0 && off_beat(interval_s, beat) > off_beat_share;
}

bool is_on_beat(const std::deque<double>& intervals_s, double interval_s) {
    const double beat = beat_s(intervals_s);
    return beat > 0.0 && off_beat(interval_s, beat) < on_beat_share;
}

void note_interval(std::deque<double>& intervals_s, double interval_s) {
    intervals_s.push_back(interval_s);
    if (intervals_s.size() > intervals_kept) intervals_s.pop_front();
}

/// True when the times rise without a jump.
template <class Times>
bool is_steady(const Times& doubtful, const std::deque<double>& intervals_s) {
    for (std::size_t i = 1; i < doubtful.size(); ++i) {
        const double interval_s = doubtful[i].recorded_s - doubtful[i - 1].recorded_s;
        if (interval_s <= 0.0 || is_jump(intervals_s, interval_s)) return false;
    }
    return true;
}

/// Intervals between the first times of a kind, without pauses.
template <class Times>
std::deque<double> intervals_of(const Times& first) {
    std::vector<double> sorted_s;
    for (const auto& event : first) sorted_s.push_back(event.recorded_s);
    std::sort(sorted_s.begin(), sorted_s.end());
    std::deque<double> all_s, intervals_s;
    for (std::size_t i = 1; i < sorted_s.size(); ++i)
        if (sorted_s[i] > sorted_s[i - 1]) all_s.push_back(sorted_s[i] - sorted_s[i - 1]);
    for (const double interval_s : all_s)
        if (!is_jump(all_s, interval_s)) intervals_s.push_back(interval_s);
    return intervals_s;
}

double time_of(const SensorEvent& event) {
    return std::visit([](const auto& e) { return e.timestamp_s; }, event);
}

EventKind kind_of(const SensorEvent& event) {
    if (std::holds_alternative<Field>(event)) return EventKind::Image;
    if (std::holds_alternative<GyroRate>(event)) return EventKind::Gyro;
    const bool wheels = std::get<PoseSample>(event).source == PoseSample::Source::Odometry;
    return wheels ? EventKind::Odometry : EventKind::GroundTruth;
}

const char* reason_against(double time_s) {
    if (std::isnan(time_s)) return "time_invalid";
    return time_s < first_allowed_s || time_s > last_allowed_s ? "time_out_of_range" : nullptr;
}

}  // namespace

const char* prefix_of(EventKind kind) {
    switch (kind) {
        case EventKind::Image:
            return "";
        case EventKind::Odometry:
            return "odometry_";
        case EventKind::GroundTruth:
            return "ground_truth_";
        case EventKind::Gyro:
            return "gyro_";
    }
    return "";
}

void EventTimes::push(SensorEvent event, InputCounts& counts) {
    const EventKind kind = kind_of(event);
    slots_.push_back({std::move(event), kind});
    if (kind == EventKind::Image) ++fields_;
    const Id id = first_id_ + slots_.size() - 1;
    if (const char* reason = reason_against(recorded_s(id))) {
        leave_out(id, reason, counts);
        return;
    }
    Track& times = track(kind);
    if (mode_ == Mode::Live) times.started = true;
    if (times.started) {
        take(id, counts);
    } else {
        times.ahead.push_back({id, recorded_s(id)});
        if (times.ahead.size() == start_events) start(kind, counts);
    }
    bound_memory(counts);
}

void EventTimes::finish(InputCounts& counts) {
    for (std::size_t k = 0; k < event_kinds; ++k) {
        const auto kind = static_cast<EventKind>(k);
        Track& times = track(kind);
        if (!times.started) start(kind, counts);
        const bool strange =
            times.ahead.size() == 1 && times.last_s &&
            is_jump(times.intervals_s, times.ahead.front().recorded_s + times.shift_s - *times.last_s);
        if (strange) {
            leave_out_all(times.ahead, "time_ahead", counts);
        } else {
            use_all(kind, times.ahead, counts);
        }
        leave_out_all(times.back, "time_backwards", counts);
    }
}

std::optional<SensorEvent> EventTimes::pop() {
    while (!slots_.empty() && slots_.front().fate != Slot::Fate::Held) {
        const bool used = slots_.front().fate == Slot::Fate::Used;
        if (slots_.front().kind == EventKind::Image) --fields_;
        std::optional<SensorEvent> event = std::move(slots_.front().event);
        slots_.pop_front();
        ++first_id_;
        if (used) return event;
    }
    return std::nullopt;
}

/// Learns the usual interval of the first events, and leaves out the first ones when they are far from all
/// others; takes the others one by one.
void EventTimes::start(EventKind kind, InputCounts& counts) {
    Track& times = track(kind);
    times.started = true;
    std::vector<Doubtful> first = std::exchange(times.ahead, {});
    const auto stranger = [&first] {  // one that is alone, while those behind it agree
        if (first.size() < start_events - 1) return false;
        const std::vector<Doubtful> others(first.begin() + 1, first.end());
        return is_steady(others, {}) && is_jump({}, std::abs(first[1].recorded_s - first[0].recorded_s));
    };
    if (stranger()) {
        leave_out(first.front().id, "time_ahead", counts);
        first.erase(first.begin());
    }
    times.intervals_s = intervals_of(first);
    times.knows_intervals = true;
    for (const Doubtful& event : first) take(event.id, counts);
    times.knows_intervals = false;
}

void EventTimes::take(Id id, InputCounts& counts) {
    Track& times = track(slot(id).kind);
    if (!times.last_s) {
        use(id, counts);
        return;
    }
    const double since_last_s = recorded_s(id) - *times.last_s;
    // A clock that was set wrong for a while is right again.
    if (times.shift_s != 0.0 && since_last_s > 0.0 && !is_jump(times.intervals_s, since_last_s))
        times.shift_s = 0.0;
    const double time_s = recorded_s(id) + times.shift_s;
    const bool repeats_held = !times.ahead.empty() && time_s == times.ahead.back().recorded_s + times.shift_s;
    if (time_s == *times.last_s || repeats_held) {
        leave_out(id, "time_repeated", counts);
    } else if (time_s < *times.last_s) {
        take_earlier(id, counts);
    } else {
        leave_out_all(times.back, "time_backwards", counts);
        take_later(id, counts);
    }
}

/// Takes an event that is later than the last used one.
void EventTimes::take_later(Id id, InputCounts& counts) {
    Track& times = track(slot(id).kind);
    if (!times.ahead.empty() && take_behind_held(id, counts)) return;
    const double interval_s = recorded_s(id) + times.shift_s - *times.last_s;
    const bool jump = is_jump(times.intervals_s, interval_s);
    const bool uneven =
        is_long(times.intervals_s, interval_s) || is_off_beat(times.intervals_s, slot(id).kind, interval_s);
    if (is_too_close(times.intervals_s, slot(id).kind, interval_s)) {
        leave_out(id, "time_too_close", counts);
    } else if (jump || (mode_ == Mode::Recording && uneven)) {
        doubt(times.ahead, id, "time_ahead", counts);
    } else {
        use(id, counts);
    }
}

/// Decides about the events that were later than expected, by the one that follows them. Returns true when
/// that one is decided as well.
bool EventTimes::take_behind_held(Id id, InputCounts& counts) {
    Track& times = track(slot(id).kind);
    const double time_s = recorded_s(id) + times.shift_s;
    const double held_s = times.ahead.back().recorded_s + times.shift_s;
    const double held_interval_s = times.ahead.front().recorded_s + times.shift_s - *times.last_s;
    if (is_jump(times.intervals_s, held_interval_s)) return is_settled_ahead(id, counts);
    const EventKind kind = slot(id).kind;
    if (time_s < held_s) {  // either was displaced: without the held one the order is right
        leave_out_all(times.ahead, "time_backwards", counts);
    } else if (is_too_close(times.intervals_s, kind, time_s - held_s)) {
        leave_out_all(times.ahead, "time_too_close", counts);
    } else if (is_off_beat(times.intervals_s, kind, held_interval_s) &&
               is_on_beat(times.intervals_s, time_s - *times.last_s)) {
        leave_out_all(times.ahead, "time_uneven", counts);
    } else {
        use_all(kind, times.ahead, counts);
    }
    return false;
}

/// Decides whether a clock jumped ahead, or single stamps are wrong. Returns true when the event is held too.
bool EventTimes::is_settled_ahead(Id id, InputCounts& counts) {
    const EventKind kind = slot(id).kind;
    Track& times = track(kind);
    const double since_last_s = recorded_s(id) + times.shift_s - *times.last_s;
    const double since_held_s = recorded_s(id) - times.ahead.back().recorded_s;
    if (since_held_s < 0.0 || !is_jump(times.intervals_s, since_last_s)) {
        leave_out_all(times.ahead, "time_ahead", counts);
        return false;
    }
    if (is_jump(times.intervals_s, since_held_s)) {  // pauses, one after the other
        use_all(kind, times.ahead, counts);
        return false;
    }
    if (times.ahead.size() < agreeing_events) {
        doubt(times.ahead, id, "time_ahead", counts);
        return true;
    }
    const std::string name = prefix_of(kind) + std::string("clock_jump");
    ++counts.warnings[name];
    double& largest_s = counts.details[name + "_s"];
    largest_s = std::max(largest_s, times.ahead.front().recorded_s + times.shift_s - *times.last_s);
    use_all(kind, times.ahead, counts);
    use(id, counts);
    return true;
}

/// Takes an event that is earlier than the last used one: it is left out, unless those after it agree with
/// it.
void EventTimes::take_earlier(Id id, InputCounts& counts) {
    const EventKind kind = slot(id).kind;
    Track& times = track(kind);
    const bool may_be_wrong =
        !times.ahead.empty() &&
        is_jump(times.intervals_s, times.ahead.front().recorded_s + times.shift_s - *times.last_s);
    if (!may_be_wrong) use_all(kind, times.ahead, counts);
    doubt(times.back, id, "time_backwards", counts);
    if (!is_steady(times.back, times.intervals_s)) {
        const Doubtful newest = times.back.back();
        times.back.pop_back();
        leave_out_all(times.back, "time_backwards", counts);
        times.back.push_back(newest);
    }
    if (times.back.size() == agreeing_events) resume_clock(kind, counts);
}

/// The clock was set back: shifts the times of the events from there on, so that they go on.
void EventTimes::resume_clock(EventKind kind, InputCounts& counts) {
    Track& times = track(kind);
    std::vector<Doubtful> back = std::exchange(times.back, {});
    const double next_s = *times.last_s + std::max(usual_s(times.intervals_s), 1e-3);
    const double wanted_s = next_s - back.front().recorded_s;
    const double known_s = near_shift(wanted_s);
    times.shift_s = back.front().recorded_s + known_s > *times.last_s ? known_s : wanted_s;
    shifts_s_.push_back(times.shift_s);
    const std::string name = prefix_of(kind) + std::string("clock_set_back");
    ++counts.warnings[name];
    double& largest_s = counts.details[name + "_s"];
    largest_s = std::max(largest_s, times.shift_s);
    use_all(kind, back, counts);
}

/// The shift of another kind whose clock was set back by nearly the same.
double EventTimes::near_shift(double shift_s) const {
    for (const double known_s : shifts_s_)
        if (std::abs(known_s - shift_s) < same_shift_s) return known_s;
    return shift_s;
}

void EventTimes::use(Id id, InputCounts& counts) {
    Slot& used = slot(id);
    Track& times = track(used.kind);
    const double time_s = recorded_s(id) + times.shift_s;
    if (times.last_s) {
        const double interval_s = time_s - *times.last_s;
        if (used.kind == EventKind::Image &&
            interval_s < irregular_share * quantile_s(times.intervals_s, 0.25))
            ++counts.warnings["time_irregular"];
        if (!times.knows_intervals && !is_jump(times.intervals_s, interval_s))
            note_interval(times.intervals_s, interval_s);
    }
    times.last_s = time_s;
    std::visit([time_s](auto& event) { event.timestamp_s = time_s; }, used.event);
    used.fate = Slot::Fate::Used;
}

void EventTimes::use_all(EventKind kind, std::vector<Doubtful>& doubtful, InputCounts& counts) {
    Track& times = track(kind);
    for (const Doubtful& event : std::exchange(doubtful, {})) {
        if (is_held(event.id)) {
            use(event.id, counts);
        } else {
            times.last_s = event.recorded_s + times.shift_s;
        }
    }
}

/// Holds the event; leaves it out when it is a live one.
void EventTimes::doubt(std::vector<Doubtful>& doubtful, Id id, const char* reason, InputCounts& counts) {
    doubtful.push_back({id, recorded_s(id)});
    if (mode_ == Mode::Live) leave_out(id, reason, counts);
}

void EventTimes::leave_out(Id id, const char* reason, InputCounts& counts) {
    slot(id).fate = Slot::Fate::LeftOut;
    ++counts.rejected[prefix_of(slot(id).kind) + std::string(reason)];
}

void EventTimes::leave_out_all(std::vector<Doubtful>& doubtful, const char* reason, InputCounts& counts) {
    for (const Doubtful& event : std::exchange(doubtful, {}))
        if (is_held(event.id)) leave_out(event.id, reason, counts);
}

/// Uses the held events when too many wait behind them.
void EventTimes::bound_memory(InputCounts& counts) {
    const bool many = slots_.size() > held_max || fields_ > held_fields_max;
    if (!many || slots_.front().fate != Slot::Fate::Held) return;
    const EventKind kind = slots_.front().kind;
    Track& times = track(kind);
    if (!times.started) {
        start(kind, counts);
        return;
    }
    leave_out_all(times.back, "time_backwards", counts);
    use_all(kind, times.ahead, counts);
}

double EventTimes::recorded_s(Id id) {
    return time_of(slot(id).event);
}

}  // namespace flownav::io
