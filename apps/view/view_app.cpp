#include "view_app.h"

#include <mrpt/3rdparty/tclap/CmdLine.h>

#include "clip.h"
#include "flownav/cli/command_output.h"
#include "flownav/cli/configuration.h"
#include "flownav/cli/exit_status.h"
#include "flownav/core/version.h"
#include "flownav/io/output_file.h"
#include "flownav/replay/replay.h"
#include "live_recorder.h"
#include "state_json.h"

namespace flownav::view {

namespace {

constexpr int usage_status = cli::exit_code(cli::ExitStatus::Usage);
constexpr double strip_after_s = 60.0;  // time read beyond a screenshot

constexpr auto help = R"(Looks at a rawlog through the optic-flow sensor: why it saw, or missed, something.

flownav-view FILE.rawlog [--config FILE.ini] [--set section.key=value]... [--follow] [--size WxH]
flownav-view FILE.rawlog --screenshot F.png [--at SECONDS] [--point U,V] [--size WxH]
flownav-view --live CONFIG.ini [--size WxH]

  FILE.rawlog               images of one camera (and odometry, ground truth), plain or gz
  --config FILE.ini         configuration; flownav-config --doc --keys everyday|all lists the keys
  --set section.key=value   sets one key, after the file; may be given several times
  --follow                  the rawlog is still being written: go on at its end
  --live CONFIG.ini         a camera, stream, video or folder, configured as for rawlog-grabber with the driver
                            CFlowObstacleSensor; its fields go to a temporary rawlog (25 PAL fields: 5.5 MB)
  --size WxH                size of the window or picture in pixels, at least 640x480, default 1440x900
  --screenshot F.png        save a picture instead of opening a window; needs no display
  --at SECONDS              the moment to show first, from the start of the drive, default 0
  --point U,V               point at this pixel of the field, as the mouse would
  --print-state             print what is shown as lines of JSON, whenever it changes
  --help, --version         print this text, or the version, and exit

Keys: space plays and pauses; left, right one field (with shift ten); home, end; up, down the speed; P predicted
vectors; C the contact scan; S saves a picture; [ and ] mark a stretch, M saves it as MP4; Q quits. The mouse: point at
a block for its numbers; click or drag in the chart to go there; turn the wheel in the map to zoom.

Exit status:
  0  fine
  1  bad usage or configuration, no such input, no image of the camera in it, or no display for a window
  2  the input is damaged or ended early; what is readable is shown
  3  output could not be written
)";

/// Parses two numbers with a separator between them.
std::pair<double, double> two_numbers(const std::string& option, const std::string& text, char separator) {
    const auto at = text.find(separator);
    try {
        std::size_t first = 0;
        std::size_t second = 0;
        if (at == std::string::npos) throw std::invalid_argument(text);
        const double a = std::stod(text.substr(0, at), &first);
        const double b = std::stod(text.substr(at + 1), &second);
        if (first == at && second == text.size() - at - 1) return {a, b};
    } catch (const std::logic_error&) {  // reported by the throw below
    }
    throw config::ConfigError(option + ' ' + text + ": needs the form A" + separator + 'B');
}

cv::Size size_of(const std::string& text) {
    const auto [width, height] = two_numbers("--size", text, 'x');
    constexpr double most = 8192;
    if (!(width >= least_width_px && width <= most && height >= least_height_px && height <= most)) {
        throw config::ConfigError("--size " + text + ": must be 640x480 to 8192x8192");
    }
    return {static_cast<int>(width), static_cast<int>(height)};
}

/// Returns the only input. Throws ConfigError for none, several, an unknown option, a missing file or a
/// folder.
std::string only_input(const std::vector<std::string>& inputs) {
    if (inputs.empty()) throw config::ConfigError("needs FILE.rawlog; try flownav-view --help");
    for (const std::string& input : inputs) {
        if (input.rfind('-', 0) == 0) {
            throw config::ConfigError("unknown argument " + input + "; try flownav-view --help");
        }
    }
    if (inputs.size() > 1) throw config::ConfigError("shows one rawlog at a time, not also " + inputs[1]);
    std::error_code problem;
    if (!std::filesystem::exists(inputs[0], problem)) throw config::ConfigError(inputs[0] + ": no such file");
    if (std::filesystem::is_directory(inputs[0], problem))
        throw config::ConfigError(inputs[0] + ": is a folder, not a rawlog");
    return inputs[0];
}

std::optional<ViewCommand> parse(const std::vector<std::string>& arguments, std::ostream& out,
                                 std::ostream& error) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-view", help, out, error);
    TCLAP::UnlabeledMultiArg<std::string> inputs("input", "", false, "FILE.rawlog", command);
    TCLAP::ValueArg<std::string> file("", "config", "", false, "", "FILE.ini", command);
    TCLAP::MultiArg<std::string> settings("", "set", "", false, "section.key=value", command);
    TCLAP::ValueArg<std::string> screenshot("", "screenshot", "", false, "", "F.png", command);
    TCLAP::ValueArg<double> at("", "at", "", false, 0.0, "SECONDS", command);
    TCLAP::ValueArg<std::string> point("", "point", "", false, "", "U,V", command);
    TCLAP::ValueArg<std::string> size("", "size", "", false, "1440x900", "WxH", command);
    TCLAP::ValueArg<std::string> live("", "live", "", false, "", "CONFIG.ini", command);
    TCLAP::SwitchArg follow("", "follow", "", command);
    TCLAP::SwitchArg print_state("", "print-state", "", command);
    if (!cli::parse_arguments(command, arguments)) {
        if (output.failed()) throw config::ConfigError("");
        return std::nullopt;
    }
    if (live.isSet() &&
        (!inputs.getValue().empty() || file.isSet() || settings.isSet() || screenshot.isSet())) {
        throw config::ConfigError(
            "--live takes all from its own ini: no FILE.rawlog, --config, --set or --screenshot");
    }
    const std::string input = live.isSet() ? "" : only_input(inputs.getValue());
    ViewCommand result;
    result.options.input = input;
    result.options.config = cli::configuration(file.getValue(), settings.getValue());
    result.options.follow = follow.getValue() || live.isSet();
    result.live = live.getValue();
    result.size = size_of(size.getValue());
    result.screenshot = screenshot.getValue();
    result.at_s = at.getValue();
    result.print_state = print_state.getValue();
    if (point.isSet()) {
        const auto [u, v] = two_numbers("--point", point.getValue(), ',');
        result.pointed_px = Eigen::Vector2d(u, v);
    }
    return result;
}

/// Returns 0 for a clean end of the input; otherwise prints the message and returns 2.
int status_of(const ViewModel& model, std::ostream& error) {
    const std::string end = model.timeline().end_text();
    if (end.empty()) return 0;
    error << "flownav-view: " << end << '\n';
    return cli::exit_code(cli::ExitStatus::Input);
}

/// Reads the drive up to `time_s`, and somewhat further for the chart.
void read_until(ViewModel& model, double time_s) {
    constexpr std::size_t at_once = 64;
    for (bool more = true; more;) {
        more = model.work(at_once);
        model.poll();
        const Timeline& timeline = model.timeline();
        if (!timeline.rows.empty() && timeline.time_s(timeline.rows.size() - 1) > time_s) return;
    }
}

int save_screenshot(const ViewCommand& command, std::ostream& out, std::ostream& error) {
    ViewOptions options = command.options;
    options.way = BackgroundReader::Way::Asked;
    options.follow = false;
    ViewModel model(options);
    read_until(model, command.at_s + strip_after_s);
    model.show_at(command.at_s);
    model.hover(command.pointed_px);
    save_picture(command.screenshot, view_picture(model, look_for(model.config()), command.size));
    if (command.print_state) out << state_json(model) << '\n';
    return status_of(model, error);
}

int look(const ViewCommand& command, const OpenWindow& open_window, std::ostream& out, std::ostream& error) {
    ViewModel model(command.options);
    model.hover(command.pointed_px);
    const int status = open_window(model, command, out, error);
    return status == 0 ? status_of(model, error) : status;
}

/// Shows a live source. The window stays open after the source has ended.
int look_live(ViewCommand command, const OpenWindow& open_window, std::ostream& out, std::ostream& error) {
    const LiveRecorder spool(command.live);
    command.options.input = spool.file();
    command.options.config = spool.config();
    command.options.name = spool.source();
    command.problem = [&spool] { return spool.problem(); };
    return look(command, open_window, out, error);
}

}  // namespace

int run_view_app(const std::vector<std::string>& arguments, const OpenWindow& open_window, std::ostream& out,
                 std::ostream& error) {
    const auto say = [&error](const std::exception& exception) {
        const std::string what = exception.what();
        if (!what.empty()) error << "flownav-view: " << what << '\n';
    };
    try {
        const auto command = parse(arguments, out, error);
        if (!command) return 0;
        if (!command->screenshot.empty()) return save_screenshot(*command, out, error);
        if (!command->live.empty()) return look_live(*command, open_window, out, error);
        return look(*command, open_window, out, error);
    } catch (const config::ConfigError& exception) {
        say(exception);
        return usage_status;
    } catch (const io::InputError& exception) {
        say(exception);
        return cli::exit_code(cli::ExitStatus::Input);
    } catch (const io::OutputError& exception) {
        say(exception);
        return cli::exit_code(cli::ExitStatus::Output);
    }
}

}  // namespace flownav::view
