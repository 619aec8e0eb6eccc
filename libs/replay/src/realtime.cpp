#include "flownav/replay/realtime.h"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>
#include <variant>

#include "flownav/cli/number_text.h"
#include "flownav/config/make_state.h"
#include "flownav/core/version.h"
#include "flownav/io/field_source.h"
#include "flownav/io/input_path.h"
#include "flownav/io/output_file.h"
#include "flownav/mapping/local_map.h"
#include "flownav/pipeline/pipeline.h"
#include "flownav/replay/obstacle_set.h"
#include "flownav/replay/realtime_replay.h"

namespace flownav::replay {

namespace {

struct Recording {
    std::vector<Field> fields;
    std::string problem;  ///< reason why it is incomplete; empty when it is complete
};

std::uint64_t bytes_of(const Field& field) {
    return static_cast<std::uint64_t>(field.image.stride_bytes) *
           static_cast<std::uint64_t>(field.image.height_px);
}

void read_fields(io::RawlogReader& reader, const RealtimeOptions& options, Recording& recording) {
    io::FieldSource source(reader, options.config.camera, options.config.input);
    std::uint64_t bytes = 0;
    while (auto event = source.next()) {
        auto* field = std::get_if<Field>(&*event);
        if (!field) continue;
        bytes += bytes_of(*field);
        if (bytes > options.memory_max_bytes) {
            throw config::ConfigError(options.input.string() + ": its decoded fields need more than the " +
                                      std::to_string(options.memory_max_bytes / 1'000'000) +
                                      " MB that --realtime holds in memory; use a shorter recording");
        }
        recording.fields.push_back(std::move(*field));
    }
    recording.problem = reader.end().message;
    if (recording.fields.size() >= 2 || !recording.problem.empty()) return;
    if (recording.fields.size() == 1)
        throw config::ConfigError(options.input.string() + ": holds one field only");
    throw config::ConfigError(
        io::why_no_field(source.counts(), options.input.string(), options.config.camera.camera_label));
}

Recording read_recording(const RealtimeOptions& options) {
    const std::string problem = io::problem_of_input(options.input);
    if (!problem.empty()) throw config::ConfigError(problem);
    Recording recording;
    try {
        io::RawlogReader reader(options.input);
        read_fields(reader, options, recording);
    } catch (const io::InputError& error) {
        recording.problem = error.what();
    }
    return recording;
}

/// Times of the fields with every pause cut to `pause_max_s`, in which nothing would happen.
struct PlayedTimes {
    std::vector<double> times_s;
    std::uint64_t cut = 0;  ///< pauses
    double cut_s = 0.0;
};

PlayedTimes played_times(const std::vector<Field>& fields, double pause_max_s) {
    PlayedTimes played;
    for (const Field& field : fields) {
        const double time_s = field.timestamp_s - played.cut_s;
        const double pause_s = played.times_s.empty() ? 0.0 : time_s - played.times_s.back();
        const double over_s = std::max(0.0, pause_s - pause_max_s);
        if (over_s > 0.0) ++played.cut;
        played.cut_s += over_s;
        played.times_s.push_back(time_s - over_s);
    }
    return played;
}

/// Pauses up to this last as long as recorded. A longer one must still begin a new chain.
double pause_max_s(const config::Config& config) {
    constexpr double longest_wait_s = 2.0;
    return std::max(longest_wait_s, 2.0 * config.pipeline.rate.gap_max_s);
}

/// Clock that sleeps on the system's steady clock. Late wake-ups count as latency, as in a robot's program.
PaceClock steady_pace() {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    const auto began = Clock::now();
    return {[began] { return Seconds(Clock::now() - began).count(); },
            [began](double time_s) {
                std::this_thread::sleep_until(began +
                                              std::chrono::duration_cast<Clock::duration>(Seconds(time_s)));
            }};
}

/// Processing chain from a field to the local map.
class Chain {
  public:
    explicit Chain(const config::Config& config) : state_(config::make_state(config)), map_(config.map) {}

    void take(const Field& field) {
        const pipeline::Step& step = pipeline::step(state_, field);
        copy_surroundings(step, set_);
        if (mapping::is_empty(set_)) {  // as in the navigation stack
            map_.redraw(step.T_start_robot);
        } else {
            map_.insert(set_);
        }
    }

  private:
    pipeline::State state_;
    mapping::ObstacleSet set_;  ///< reused to avoid allocations
    mapping::LocalMap map_;
};

PacedFields play(const std::vector<Field>& fields, const PlayedTimes& played,
                 const RealtimeOptions& options) {
    const RepeatedTimes times(played.times_s);
    Chain chain(options.config);
    const auto work = [&](std::uint64_t n) {
        Field field = fields[times.field(n)];
        field.timestamp_s = played.times_s.front() + times.after_start_s(n);
        chain.take(field);
    };
    const std::uint64_t count = times.count_within(options.duration_s.value_or(times.once_s()));
    return replay_paced(times, count, steady_pace(), work);
}

/// Scheduling policy of this process, named as by chrt(1).
std::string scheduling() {
    switch (sched_getscheduler(0)) {
        case SCHED_FIFO:
            return "fifo";
        case SCHED_RR:
            return "rr";
        default:
            return "other";
    }
}

double ms(double seconds) {
    return std::round(seconds * 1e6) / 1e3;  // rounds to whole microseconds
}

std::string to_json(const PacedFields& paced, const LatencyFigures& figures, const RealtimeOptions& options) {
    const nlohmann::ordered_json json = {{"program", "flownav-replay"},
                                         {"version", version()},
                                         {"input", options.input.filename().string()},
                                         {"kernel", pipeline::kernel_name()},
                                         {"threads", options.config.pipeline.threads},
                                         {"scheduling", scheduling()},
                                         {"fields", paced.arrived},
                                         {"dropped", paced.dropped},
                                         {"latency_ms",
                                          {{"median", ms(figures.median_s)},
                                           {"p99", ms(figures.p99_s)},
                                           {"p99_9", ms(figures.p999_s)},
                                           {"worst", ms(figures.worst_s)}}}};
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

std::string to_words(const PacedFields& paced, const LatencyFigures& figures) {
    const auto text = [](double seconds) { return cli::fixed_text(1000 * seconds, 3); };
    return std::to_string(paced.arrived) + " fields, " + std::to_string(paced.dropped) +
           " dropped; latency in ms: median " + text(figures.median_s) + ", 99 % " + text(figures.p99_s) +
           ", 99.9 % " + text(figures.p999_s) + ", worst " + text(figures.worst_s);
}

ReplayResult run(const RealtimeOptions& options) {
    const Recording recording = read_recording(options);
    ReplayResult result;
    result.message = recording.problem;
    if (!recording.problem.empty()) result.status = cli::ExitStatus::Input;
    if (recording.fields.size() < 2) return result;
    if (recording.fields.back().timestamp_s <= recording.fields.front().timestamp_s)
        throw config::ConfigError(options.input.string() + ": its fields do not follow each other in time");
    if (!options.output.empty()) io::make_output_folder(options.output);
    const PlayedTimes played = played_times(recording.fields, pause_max_s(options.config));
    const PacedFields paced = play(recording.fields, played, options);
    const LatencyFigures figures = latency_figures(paced.latencies_s);
    if (!options.output.empty())
        io::write_file(options.output / "realtime.json", to_json(paced, figures, options));
    result.outcome = to_words(paced, figures);
    if (played.cut > 0) {
        result.warnings.push_back(std::to_string(played.cut) +
                                  (played.cut == 1 ? " pause was" : " pauses were") + " cut short by " +
                                  cli::fixed_text(played.cut_s, 1) +
                                  " s in all: --realtime waits for no more than " +
                                  cli::fixed_text(pause_max_s(options.config), 1) + " s");
    }
    return result;
}

}  // namespace

ReplayResult replay_realtime(const RealtimeOptions& options) {
    try {
        return run(options);
    } catch (const config::ConfigError& error) {
        return {cli::ExitStatus::Usage, error.what(), {}, ""};
    } catch (const io::OutputError& error) {
        return {cli::ExitStatus::Output, error.what(), {}, ""};
    }
}

}  // namespace flownav::replay
