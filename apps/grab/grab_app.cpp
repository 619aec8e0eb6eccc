#include "grab_app.h"

#include <mrpt/3rdparty/tclap/CmdLine.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/system/os.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "flownav/cli/command_output.h"
#include "flownav/cli/usage_error.h"
#include "flownav/core/version.h"
#include "flownav/io/flow_obstacle_sensor.h"
#include "flownav/io/output_file.h"
#include "grab_progress.h"
#include "grabber.h"

namespace flownav {

namespace {

constexpr int usage_status = static_cast<int>(GrabStatus::Usage);

constexpr auto help = R"(Records sensors into a rawlog, as rawlog-grabber does and with its ini files.

flownav-grab CONFIG.ini --output F.rawlog [--max-size MB] [--overwrite] [--duration SECONDS]
             [--silence SECONDS] [--queue MB] [--plugin FILE.so]... [--quiet]

  CONFIG.ini            one section a sensor: driver and process_rate (Hz), and the keys of the driver. All
                        drivers of MRPT, and CFlowObstacleSensor. Of [global], rawlog_GZ_compress_level
                        (0..9, default 1) and time_between_launches (ms, default 0) are followed; a
                        section with rawlog-grabber-ignore = true is left out
  --output F.rawlog     the recording, a gz list of observations; images are inside
  --max-size MB         begin a new file before this one is larger: F.rawlog, F_001.rawlog, F_002.rawlog, ...
                        (1 MB = 1,000,000 bytes on the disk); each can be read by itself
  --overwrite           replace F.rawlog, and F_001.rawlog, ... with it; without it, existing files are an
                        error
  --duration SECONDS    end after this time; without it, Ctrl-C or SIGTERM end the recording
  --silence SECONDS     a sensor that observes nothing for longer has failed; default 10, 0: it may be silent
  --queue MB            memory for observations that wait for the disk, default 256
  --plugin FILE.so      load drivers of another library; may be given several times
  --quiet               no progress and no closing line
  --help, --version     print this text, or the version, and exit

Observations are written in the order of their time stamps, as far as they arrive within 0.1 s of each other;
what comes later than that is written too, and counted. Whatever happens to the program, even SIGKILL, the file
can be read, and lacks the last half second at most. Capturing never waits for the disk: when the disk is so
slow that the queue is full, observations are dropped, counted and reported. Sources that are files wait
instead.

Exit status:
  0  fine: ended by a signal or --duration, or every source was a file and has been read to its end
  1  bad usage or configuration, or the file exists; nothing was written
  2  a sensor failed; the message names it. All that was captured is in the recording
  3  the recording could not be written, such as on a full disk; it is complete up to there
  4  the disk was too slow and observations were dropped; the message says how many of which sensor
)";

struct CommandLine {
    std::string config;
    std::vector<std::string> plugins;
    GrabOptions options;
    bool quiet = false;
};

/// Throws for a value that is not a number or outside the limits; infinity exceeds every limit.
void require_range(const char* option, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw cli::UsageError(std::string(option) + ": must be " + std::to_string(low) + " .. " +
                          std::to_string(high));
}

std::uint64_t bytes_of(double megabytes) {
    return static_cast<std::uint64_t>(std::llround(megabytes * 1e6));
}

/// Parses the arguments; empty when they have been answered, with the exit status in `status`.
std::optional<CommandLine> parse(const std::vector<std::string>& arguments, std::ostream& out,
                                 std::ostream& error, int& status) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-grab", help, out, error);
    TCLAP::UnlabeledValueArg<std::string> config("config", "", false, "", "CONFIG.ini", command);
    TCLAP::ValueArg<std::string> file("", "output", "", false, "", "F.rawlog", command);
    TCLAP::ValueArg<double> max_size("", "max-size", "", false, 0, "MB", command);
    TCLAP::SwitchArg overwrite("", "overwrite", "", command);
    TCLAP::ValueArg<double> duration("", "duration", "", false, 0, "SECONDS", command);
    TCLAP::ValueArg<double> silence("", "silence", "", false, 10, "SECONDS", command);
    TCLAP::ValueArg<double> queue("", "queue", "", false, 256, "MB", command);
    TCLAP::MultiArg<std::string> plugins("", "plugin", "", false, "FILE.so", command);
    TCLAP::SwitchArg quiet("", "quiet", "", command);

    const auto refuse = [&](const std::string& message) {
        output.fail(message);
        status = usage_status;
        return std::nullopt;
    };
    if (!cli::parse_arguments(command, arguments)) {
        status = output.failed() ? usage_status : 0;
        return std::nullopt;
    }
    if (config.getValue().rfind('-', 0) == 0)  // TCLAP takes an unknown option as the file
        return refuse("unknown argument " + config.getValue());
    if (!config.isSet() || !file.isSet()) return refuse("needs CONFIG.ini and --output F.rawlog");
    if (max_size.isSet()) require_range("--max-size", max_size.getValue(), 0.001, 1e9);
    if (duration.isSet()) require_range("--duration", duration.getValue(), 0.001, 1e9);
    require_range("--silence", silence.getValue(), 0, 1e9);
    require_range("--queue", queue.getValue(), 0.001, 1e6);
    CommandLine result;
    result.config = config.getValue();
    result.plugins = plugins.getValue();
    result.quiet = quiet.getValue();
    GrabOptions& options = result.options;
    options.recording.file = file.getValue();
    options.recording.max_bytes = bytes_of(max_size.getValue());
    options.recording.overwrite = overwrite.getValue();
    options.duration_s = duration.getValue();
    options.silence_s = silence.getValue();
    options.queue_bytes = bytes_of(queue.getValue());
    return result;
}

void load_plugins(const std::vector<std::string>& plugins) {
    for (const std::string& plugin : plugins) {
        std::string reason;
        if (mrpt::system::loadPluginModule(plugin, reason)) continue;
        std::string message = "--plugin " + plugin;
        message += ": cannot be loaded: ";
        throw cli::UsageError(message + reason);
    }
}

int grab(const CommandLine& command, const cli::StopSignals& signals, std::ostream& out,
         std::ostream& error) {
    load_plugins(command.plugins);
    CFlowObstacleSensor::doRegister();
    const GrabSetup setup = read_grab_setup(command.config);
    for (const std::string& warning : setup.warnings) error << "flownav-grab: warning: " << warning << '\n';
    GrabOptions options = command.options;
    options.recording.gz_level = setup.gz_level;
    Grabber grabber(setup, options);
    GrabProgress progress(std::cout, command.quiet);
    while (!grabber.done()) {
        if (signals.wait(std::chrono::milliseconds(50))) break;
        progress.update(grabber.elapsed_s(), grabber.counts());
    }
    const GrabResult result = grabber.finish();
    progress.finish();
    for (const std::string& message : result.messages) error << "flownav-grab: " << message << '\n';
    if (!command.quiet) out << outcome_text(grabber) << '\n';
    const int status = static_cast<int>(result.status);
    if (result.hanging) {
        out.flush();
        error.flush();
        std::_Exit(status);
    }
    return status;
}

}  // namespace

int run_grab_app(const std::vector<std::string>& arguments, const cli::StopSignals& signals,
                 std::ostream& out, std::ostream& error) {
    try {
        int status = 0;
        const auto command = parse(arguments, out, error, status);
        return command ? grab(*command, signals, out, error) : status;
    } catch (const cli::UsageError& exception) {
        error << "flownav-grab: " << exception.what() << '\n';
        return usage_status;
    } catch (const FileExists& exception) {
        error << "flownav-grab: " << exception.what() << '\n';
        return usage_status;
    } catch (const io::OutputError& exception) {
        error << "flownav-grab: " << exception.what() << '\n';
        return static_cast<int>(GrabStatus::Output);
    }
}

}  // namespace flownav
