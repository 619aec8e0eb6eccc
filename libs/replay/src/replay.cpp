#include "flownav/replay/replay.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <system_error>
#include <variant>

#include "flownav/cli/number_text.h"
#include "flownav/cli/usage_error.h"
#include "flownav/config/make_state.h"
#include "flownav/evaluation/drive.h"
#include "flownav/evaluation/profiler.h"
#include "flownav/io/decode_ahead.h"
#include "flownav/io/input_path.h"
#include "flownav/io/note_reading.h"
#include "flownav/pipeline/pipeline.h"
#include "flownav/replay/outputs.h"

namespace flownav::replay {

namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// True when two paths lead to the same file, which may not exist yet.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    if (std::filesystem::equivalent(a, b, error)) return true;
    return std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error);
}

class Run {
  public:
    explicit Run(const ReplayOptions& options)
        : options_(options),
          state_(options.config.pipeline,
                 clock_.timed(config::make_matcher(matching(options.config.pipeline)))) {
        timing_.threads = options.config.pipeline.threads;
        thumbnail_strip_ = report::ThumbnailStrip(several_threads());
        const std::string& matcher = options.config.pipeline.flow.matcher;
        timing_.kernel = matcher == "sad" ? pipeline::kernel_name() : matcher;
        drive_.input_name = options.input.filename().string();
    }

    ReplayResult result() {
        refuse_bad_paths();
        read();
        finish();
        clock_.report(timing_);
        outputs_->write_summary(drive_, timing_);
        return {status(), message(), warnings(), outcome()};
    }

  private:
    bool several_threads() const { return options_.config.pipeline.threads > 1; }

    /// Parameters of the matcher: one of several threads decodes, the others match.
    static pipeline::Params matching(pipeline::Params params) {
        params.threads = std::max(1, params.threads - 1);
        return params;
    }

    void refuse_bad_paths() const {
        const std::string problem = io::problem_of_input(options_.input);
        if (!problem.empty()) throw cli::UsageError(problem);
        std::error_code error;
        const auto result = options_.output / "result.rawlog";
        if (std::filesystem::equivalent(options_.input, result, error)) {
            throw cli::UsageError(options_.input.string() +
                                  " would be overwritten by result.rawlog: choose another --output");
        }
        refuse_overwriting("--flow-field", options_.optional.flow_field);
        refuse_overwriting("--video", options_.optional.video);
        const auto& [keep_images, video, flow_field] = options_.optional;
        if (!video.empty() && same_file(video, flow_field))
            throw cli::UsageError("--video and --flow-field name the same file, " + video.string());
    }

    /// Throws UsageError when a requested file is the input or a file of the output folder.
    void refuse_overwriting(const std::string& option, const std::filesystem::path& file) const {
        if (file.empty()) return;
        const auto refuse = [&](const std::string& what) {
            throw cli::UsageError(option + ' ' + file.string() + ": would overwrite " + what +
                                  "; choose another file");
        };
        if (same_file(file, options_.input)) refuse("the input");
        for (const char* name : output_names())
            if (same_file(file, options_.output / name)) refuse(name + std::string(" of --output"));
    }

    void read() {
        try {
            io::RawlogReader reader(options_.input);
            read_events(reader);
            drive_.end = reader.end();
        } catch (const io::InputError& error) {
            drive_.end.kind = io::ReadEnd::Kind::Corrupt;
            drive_.end.message = error.what();
        }
        // The results must not depend on the folder of the input.
        replace_all(drive_.end.message, options_.input.string(), drive_.input_name);
        if (!outputs_ && drive_.end.kind == io::ReadEnd::Kind::Clean) {
            throw cli::UsageError(
                io::why_no_field(drive_.read, options_.input.string(), options_.config.camera.camera_label));
        }
    }

    void read_events(io::RawlogReader& reader) {
        io::FieldSource source(reader, options_.config.camera, options_.config.input);
        std::optional<io::DecodeAhead> ahead;
        if (several_threads()) start(ahead, source, reader);
        cli::Progress progress(std::cout, options_.progress);
        for (;;) {
            const io::Decoded decoded = ahead ? next([&] { return ahead->next(); })
                                              : next([&] { return io::decode_next(source, reader); });
            if (!decoded.event) break;
            io::note_reading(state_, *decoded.event);
            if (const auto* field = std::get_if<Field>(&*decoded.event)) take(*field);
            if (const auto* sample = std::get_if<io::PoseSample>(&*decoded.event)) take(*sample);
            progress.update(decoded.progress, drive_.rows.size());
        }
        progress.finish(drive_.rows.size());
        drive_.read = source.counts();
    }

    static void start(std::optional<io::DecodeAhead>& ahead, io::FieldSource& source,
                      const io::RawlogReader& reader) {
        try {
            ahead.emplace(source, reader);
        } catch (const std::system_error&) {
            // Without a second thread, this one decodes as well.
        }
    }

    template <typename Decode>
    io::Decoded next(const Decode& decode) {
        clock_.enter(evaluation::Profiler::other);  // idle time is not attributed to a stage
        try {
            io::Decoded decoded = decode();
            clock_.credit(&evaluation::StageTimes::decode_s, decoded.decode_s);
            return decoded;
        } catch (const config::ConfigError& error) {
            if (!outputs_) throw;  // no file has been written yet
            drive_.stop_reason = error.what();
            return {};
        }
    }

    void take(const Field& field) {
        open_outputs();
        clock_.enter(&evaluation::StageTimes::motion_s);
        const pipeline::Step& step = pipeline::step(state_, field);
        clock_.enter(evaluation::Profiler::other);
        drive_.rows.push_back(evaluation::row_of(step));
        checker_.take(field, step);
        clock_.enter(&evaluation::StageTimes::map_s);
        outputs_->map(step);
        clock_.enter(&evaluation::StageTimes::write_s);
        thumbnail_strip_.offer(field, step);
        outputs_->write(field, step);
        clock_.end_field(field.timestamp_s);
    }

    void take(const io::PoseSample& sample) {
        const bool truth = sample.source == io::PoseSample::Source::GroundTruth;
        (truth ? drive_.ground_truth : drive_.odometry).add(sample.timestamp_s, sample.pose);
        if (truth) return;
        if (outputs_) {
            outputs_->write_odometry(sample);
        } else {
            early_odometry_.push_back(sample);
        }
    }

    /// Opens the outputs at the first usable field, so that bad configuration writes no file.
    void open_outputs() {
        if (outputs_) return;
        clock_.enter(&evaluation::StageTimes::write_s);
        outputs_.emplace(options_.output, options_.config, options_.optional);
        for (const io::PoseSample& sample : early_odometry_) outputs_->write_odometry(sample);
        early_odometry_.clear();
    }

    void finish() {
        open_outputs();
        clock_.enter(&evaluation::StageTimes::write_s);
        thumbnail_strip_.finish();
        drive_.odometry.finish();
        drive_.ground_truth.finish();
        if (!drive_.odometry.empty())
            drive_.odometry_errors = evaluation::compare(drive_.rows, drive_.odometry);
        if (!drive_.ground_truth.empty())
            drive_.ground_truth_errors = evaluation::compare(drive_.rows, drive_.ground_truth);
        drive_.camera_check = checker_.result(drive_.odometry);
        drive_.field_faults = state_.last_step().faults;
        const mapping::GlobalMap& map = outputs_->global_map();
        drive_.findings = evaluation::judge(
            drive_, options_.config, evaluation::map_warning(map.sets(), map.sets_outside(), map.half_m()));
        clock_.report(timing_);
        outputs_->finish(drive_, thumbnail_strip_, options_.timing_in_report ? &timing_ : nullptr);
    }

    bool is_whole() const {
        return drive_.end.kind == io::ReadEnd::Kind::Clean && drive_.stop_reason.empty();
    }

    cli::ExitStatus status() const {
        const auto is_serious = [this](const evaluation::Finding& finding) {
            return finding.loses_data || options_.strict;
        };
        const bool fine =
            is_whole() && std::none_of(drive_.findings.begin(), drive_.findings.end(), is_serious);
        return fine ? cli::ExitStatus::Fine : cli::ExitStatus::Input;
    }

    std::vector<std::string> warnings() const {
        std::vector<std::string> all;
        for (const evaluation::Finding& finding : drive_.findings) all.push_back(finding.sentence);
        return all;
    }

    std::string message() const {
        if (is_whole()) return "";
        return evaluation::end_sentence(drive_);
    }

    std::string outcome() const {
        const std::uint64_t ok = evaluation::status_counts(drive_.rows).front();
        return std::to_string(drive_.rows.size()) + (drive_.rows.size() == 1 ? " field (" : " fields (") +
               std::to_string(ok) + " ok), " + std::to_string(drive_.written.cycles) + " cycles, " +
               std::to_string(drive_.written.obstacle_points) + " obstacle points; see " +
               (options_.output / "report.html").string();
    }

    const ReplayOptions& options_;
    evaluation::Profiler clock_;
    pipeline::State state_;
    evaluation::CameraChecker checker_{options_.config.pipeline.motion.geometry};
    evaluation::Drive drive_;
    report::ThumbnailStrip thumbnail_strip_;
    evaluation::Timing timing_;
    std::vector<io::PoseSample> early_odometry_;
    std::optional<Outputs> outputs_;
};

}  // namespace

ReplayResult replay(const ReplayOptions& options) {
    try {
        return Run(options).result();
    } catch (const cli::UsageError& error) {
        return {cli::ExitStatus::Usage, error.what(), {}, ""};
    } catch (const config::ConfigError& error) {
        return {cli::ExitStatus::Usage, error.what(), {}, ""};
    } catch (const io::OutputError& error) {
        return {cli::ExitStatus::Output, error.what(), {}, ""};
    }
}

}  // namespace flownav::replay
