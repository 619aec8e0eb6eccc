#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "flownav/io/sensor_event.h"

namespace flownav::io {

/// Kinds of events whose times rise independently of each other.
enum class EventKind { Image, Odometry, GroundTruth, Gyro };
inline constexpr std::size_t event_kinds = 4;

/// Prefix of the reasons that are counted for a kind: "", odometry_, ground_truth_ or gyro_.
const char* prefix_of(EventKind kind);

/// Puts right the times of events. Within each kind the times of the events that pop() returns rise strictly;
/// all events keep the order of push().
///
/// Left out, and counted in InputCounts::rejected under the prefix of the kind: time_invalid,
/// time_out_of_range (before 1970 or after 2100), time_repeated, time_backwards, time_ahead (single stamps
/// far from those before and after), and of images time_too_close (much closer to the one before, or to the
/// one after, than usual: such a pair has wrong stamps, or is one image twice) and time_uneven (single stamps
/// off the beat of a regular camera).
///
/// Mended, and counted in InputCounts::warnings: clock_set_back (the times of all that follow are shifted so
/// that they go on), clock_jump (a pause, or a clock set ahead), and of images time_irregular (less than 0.4
/// of the usual interval). The largest shift is in InputCounts::details.
class EventTimes {
  public:
    /// How many events may be held until those after them decide about their times.
    enum class Mode { Recording, Live };  ///< a live event is never held

    explicit EventTimes(Mode mode) : mode_(mode) {}

    void push(SensorEvent event, InputCounts& counts);

    /// No more events come: decides about those that are held.
    void finish(InputCounts& counts);

    /// Next event whose time is decided; empty when more events are needed.
    std::optional<SensorEvent> pop();

  private:
    using Id = std::uint64_t;

    struct Slot {
        enum class Fate { Held, Used, LeftOut };
        SensorEvent event;
        EventKind kind;
        Fate fate = Fate::Held;
    };

    /// An event whose time is not decided; a live one has been left out already.
    struct Doubtful {
        Id id;
        double recorded_s;
    };

    /// The times of one kind.
    struct Track {
        bool started = false;
        bool knows_intervals = false;    ///< those of the events that are taken now are counted already
        std::optional<double> last_s;    ///< of the last used event, shifted
        std::deque<double> intervals_s;  ///< the latest, between used events
        double shift_s = 0.0;            ///< added to the recorded times
        std::vector<Doubtful> ahead;     ///< later than expected
        std::vector<Doubtful> back;      ///< earlier than `last_s`, rising
    };

    void start(EventKind kind, InputCounts& counts);
    void take(Id id, InputCounts& counts);
    void take_later(Id id, InputCounts& counts);
    bool take_behind_held(Id id, InputCounts& counts);
    bool is_settled_ahead(Id id, InputCounts& counts);
    void take_earlier(Id id, InputCounts& counts);
    void resume_clock(EventKind kind, InputCounts& counts);
    void use(Id id, InputCounts& counts);
    void use_all(EventKind kind, std::vector<Doubtful>& doubtful, InputCounts& counts);
    void doubt(std::vector<Doubtful>& doubtful, Id id, const char* reason, InputCounts& counts);
    void leave_out(Id id, const char* reason, InputCounts& counts);
    void leave_out_all(std::vector<Doubtful>& doubtful, const char* reason, InputCounts& counts);
    double near_shift(double shift_s) const;
    void bound_memory(InputCounts& counts);

    Slot& slot(Id id) { return slots_[id - first_id_]; }
    bool is_held(Id id) { return id >= first_id_ && slot(id).fate == Slot::Fate::Held; }
    Track& track(EventKind kind) { return tracks_.at(static_cast<std::size_t>(kind)); }
    double recorded_s(Id id);

    Mode mode_;
    std::deque<Slot> slots_;
    Id first_id_ = 0;
    std::size_t fields_ = 0;  ///< among the slots
    std::array<Track, event_kinds> tracks_;
    std::vector<double> shifts_s_;  ///< of all kinds so far
};

}  // namespace flownav::io
