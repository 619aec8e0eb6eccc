#include "replay_app.h"

#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <iostream>
#include <optional>

#include "flownav/cli/command_output.h"
#include "flownav/cli/configuration.h"
#include "flownav/cli/exit_status.h"
#include "flownav/config/config.h"
#include "flownav/core/version.h"
#include "flownav/replay/realtime.h"
#include "flownav/replay/replay.h"

namespace flownav {

namespace {

constexpr int usage_status = cli::exit_code(cli::ExitStatus::Usage);
constexpr int most_threads = 64;
constexpr double longest_run_s = 1e6;

constexpr auto help = R"(Replays a rawlog through the optic-flow sensor.

flownav-replay INPUT.rawlog --output DIR [--config FILE.ini] [--set section.key=value]...
               [--video FILE.mp4] [--flow-field FILE.rawlog] [--keep-images] [--timing] [--threads N]
               [--strict] [--quiet]
flownav-replay INPUT.rawlog --realtime [--for-s S] [--output DIR] [--config FILE.ini]
               [--set section.key=value]... [--threads N] [--quiet]

  INPUT.rawlog              images of one camera (and odometry, ground truth), plain or gz
  --output DIR              folder for the results; made when it is missing, old results are overwritten
  --config FILE.ini         configuration; flownav-config --doc --keys everyday|all lists the keys
  --set section.key=value   sets one key, after the file; may be given several times
  --video FILE.mp4          also make a video of the drive: annotated fields side by side with the growing map
  --flow-field FILE.rawlog  also write the whole record of every field: blocks with vectors, predictions and
                            labels, motion, obstacles; for MRPT's tools with the plug-in libflownav-sensor.so
  --keep-images             copy the fields as they were used into result.rawlog
  --timing                  show the time per stage in report.html too; it then differs from run to run
  --threads N               1..64, default 1; from 2 on one decodes ahead and draws the report's pictures
                            while the others match blocks; with --realtime all match. The results do not
                            depend on it
  --realtime                fields come at their time stamps, as from a camera, from memory (up to 2 GB);
                            a field still waiting when a newer one comes is dropped, and a pause is cut to
                            2 s, or twice motion.gap_max_s. Prints the latency from
                            a field's arrival until the local map, the navigator's input, is ready: median,
                            99 %, 99.9 %, worst, and the fields dropped; DIR gets realtime.json only
  --for-s S                 how long --realtime lasts; the recording begins again, with rising time stamps,
                            as often as needed; default once
  --strict                  any warning makes the exit status 2, not only those about lost data
  --quiet                   no progress and no closing line
  --help, --version         print this text, or the version, and exit

Writes into DIR:
  report.html               linked charts, way, map, pictures and every figure in words, for a web browser
  summary.json              what was read, rejected and written; errors; configuration; timing
  trajectory.tum            flow odometry, one pose a field: timestamp x y z qx qy qz qw
  odometry.tum, ground_truth.tum   the same for the recording's own poses, where it has them
  egomotion.csv             one row a field: status, turn rate, speed, counts
  obstacles.csv             one row an obstacle point, robot frame (x forward, y left, z up; metres)
  contacts.csv              one row a strip of every scanned cycle: confirmed floor, contact, cause
  map.pgm, map.yaml, map.gridmap.gz   the map of the drive, for ROS and for MRPT
  result.rawlog             odometry, FLOW_ODOMETRY, FLOW_POSE, FLOW_SCAN, FLOW_POINTS for MRPT's tools

Exit status:
  0  fine
  1  bad usage or configuration, no such input, or no image of the camera in it; nothing was written
  2  the input is damaged, ended early or is no rawlog, or a warning says that data were lost; all that was
     readable was written, and summary.json says where and why
  3  output could not be written
)";

struct CommandLine {
    replay::ReplayOptions options;
    bool realtime = false;
    std::optional<double> duration_s;  ///< limit of a run in real time
    bool quiet = false;
};

/// Reads the configuration and sets the number of threads. Throws ConfigError.
config::Config configuration(const std::string& file, const std::vector<std::string>& settings, int threads) {
    config::Config config = cli::configuration(file, settings);
    if (threads < 1 || threads > most_threads) {
        throw config::ConfigError("--threads " + std::to_string(threads) + ": must be 1.." +
                                  std::to_string(most_threads));
    }
    config.pipeline.threads = threads;
    return config;
}

/// Describes missing or contradictory options; empty when they are valid.
std::string contradiction(const CommandLine& line, bool input, bool output) {
    if (!line.realtime) {
        if (!input || !output) return "needs INPUT.rawlog and --output DIR";
        return line.duration_s ? "--for-s needs --realtime" : "";
    }
    if (!input) return "needs INPUT.rawlog";
    if (line.duration_s && !(*line.duration_s > 0.0 && *line.duration_s <= longest_run_s))
        return "--for-s must be over 0 and at most 1000000 seconds";
    const replay::OptionalOutputs& optional = line.options.optional;
    const bool more = optional.keep_images || !optional.video.empty() || !optional.flow_field.empty();
    if (more || line.options.timing_in_report)
        return "--realtime writes none of --video, --flow-field, --keep-images, --timing";
    return "";
}

/// Parses the arguments; empty when they have been answered, with the exit status in `status`.
std::optional<CommandLine> parse(const std::vector<std::string>& arguments, std::ostream& out,
                                 std::ostream& error, int& status) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-replay", help, out, error);
    TCLAP::UnlabeledValueArg<std::string> input("input", "", false, "", "INPUT.rawlog", command);
    TCLAP::ValueArg<std::string> folder("", "output", "", false, "", "DIR", command);
    TCLAP::ValueArg<std::string> file("", "config", "", false, "", "FILE.ini", command);
    TCLAP::MultiArg<std::string> settings("", "set", "", false, "section.key=value", command);
    TCLAP::ValueArg<int> threads("", "threads", "", false, 1, "N", command);
    TCLAP::ValueArg<std::string> video("", "video", "", false, "", "FILE.mp4", command);
    TCLAP::ValueArg<std::string> flow_field("", "flow-field", "", false, "", "FILE.rawlog", command);
    TCLAP::SwitchArg keep_images("", "keep-images", "", command);
    TCLAP::SwitchArg timing("", "timing", "", command);
    TCLAP::SwitchArg realtime("", "realtime", "", command);
    TCLAP::ValueArg<double> duration_s("", "for-s", "", false, 0.0, "S", command);
    TCLAP::SwitchArg strict("", "strict", "", command);
    TCLAP::SwitchArg quiet("", "quiet", "", command);

    if (!cli::parse_arguments(command, arguments)) {
        status = output.failed() ? usage_status : 0;
        return std::nullopt;
    }
    if (input.getValue().rfind('-', 0) == 0) {  // TCLAP takes an unknown option as the input
        output.fail("unknown argument " + input.getValue());
        status = usage_status;
        return std::nullopt;
    }
    CommandLine result;
    result.realtime = realtime.getValue();
    if (duration_s.isSet()) result.duration_s = duration_s.getValue();
    result.quiet = quiet.getValue();
    result.options.input = input.getValue();
    result.options.output = folder.getValue();
    result.options.optional.keep_images = keep_images.getValue();
    result.options.optional.video = video.getValue();
    result.options.optional.flow_field = flow_field.getValue();
    result.options.timing_in_report = timing.getValue();
    result.options.strict = strict.getValue();
    const std::string problem = contradiction(result, input.isSet(), folder.isSet());
    if (!problem.empty()) {
        output.fail(problem);
        status = usage_status;
        return std::nullopt;
    }
    result.options.config = configuration(file.getValue(), settings.getValue(), threads.getValue());
    if (!result.quiet) result.options.progress = cli::Progress::style_for(std::cout);
    return result;
}

replay::ReplayResult run(const CommandLine& command) {
    if (!command.realtime) return replay::replay(command.options);
    replay::RealtimeOptions options;
    options.input = command.options.input;
    options.output = command.options.output;
    options.config = command.options.config;
    options.duration_s = command.duration_s;
    return replay::replay_realtime(options);
}

}  // namespace

int run_replay_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    try {
        int status = 0;
        const auto command = parse(arguments, out, error, status);
        if (!command) return status;
        const replay::ReplayResult result = run(*command);
        if (!result.message.empty()) error << "flownav-replay: " << result.message << '\n';
        for (const std::string& warning : result.warnings)
            error << "flownav-replay: warning: " << warning << '\n';
        if (!command->quiet && !result.outcome.empty()) out << result.outcome << '\n';
        return cli::exit_code(result.status);
    } catch (const config::ConfigError& exception) {
        error << "flownav-replay: " << exception.what() << '\n';
        return usage_status;
    }
}

}  // namespace flownav
