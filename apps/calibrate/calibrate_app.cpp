#include "calibrate_app.h"

#include <iostream>
#include <optional>

#include "flownav/calibration/calibration.h"
#include "flownav/cli/command_output.h"
#include "flownav/cli/configuration.h"
#include "flownav/core/version.h"

namespace flownav {
namespace {

constexpr int usage_status = static_cast<int>(calibration::CalibrationStatus::Usage);

constexpr auto help = R"(Estimates how a camera sits on its robot from a drive over a textured, level floor.

flownav-calibrate INPUT.rawlog --output CAM.ini [--odometry] [--config FILE.ini] [--set section.key=value]...
                  [--picture FILE.png] [--quiet]

  INPUT.rawlog              images of one camera, a few metres of driving, straight and turning
  --output CAM.ini          the camera's pose, for flownav-replay --config; holds the settings of FILE.ini too
  --odometry                estimate the height too, from the recording's odometry; without it the height stays
  --config FILE.ini         what is known of the camera; pitch, roll and yaw are where the estimate starts
  --set section.key=value   sets one key, after the file; may be given several times
  --picture FILE.png        residuals of the floor's vectors before and after
  --quiet                   no progress and no values
  --help, --version         print this text, or the version, and exit

Estimates camera.pitch_deg, roll_deg and yaw_deg, and with --odometry height_m, each with its uncertainty (one
standard deviation of what differs from place to place; a floor that is not level and a wrong focal length are not in
it). A value that the drive does not determine stays as it was. The pitch may be unknown, or wrong by any amount.

Exit status:
  0  fine
  1  bad usage or configuration, no such input, or no image of the camera in it; nothing was written
  2  the input is damaged or ended early; what was readable was used. No rawlog at all: nothing was written
  3  output could not be written
  4  the drive does not determine the pitch: the robot stands still or only turns, or there is no texture or
     no floor; nothing was written
)";

struct CommandLine {
    calibration::CalibrationOptions options;
    bool quiet = false;
};

/// Parses the arguments; empty when they have been answered, with the exit status in `status`.
std::optional<CommandLine> parse(const std::vector<std::string>& arguments, std::ostream& out,
                                 std::ostream& error, int& status) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-calibrate", help, out, error);
    using Text = TCLAP::ValueArg<std::string>;
    TCLAP::UnlabeledMultiArg<std::string> inputs("input", "", false, "INPUT.rawlog", command);
    Text file("", "output", "", false, "", "CAM.ini", command);
    Text config("", "config", "", false, "", "FILE.ini", command);
    Text picture("", "picture", "", false, "", "FILE.png", command);
    TCLAP::MultiArg<std::string> settings("", "set", "", false, "section.key=value", command);
    TCLAP::SwitchArg odometry("", "odometry", "", command);
    TCLAP::SwitchArg quiet("", "quiet", "", command);

    const bool parsed = cli::parse_arguments(command, arguments);
    const std::string input = inputs.isSet() ? inputs.getValue().front() : "";
    if (parsed && input.rfind('-', 0) == 0) {  // TCLAP takes an unknown option as the input
        output.fail("unknown argument " + input);
    } else if (parsed && (inputs.getValue().size() != 1 || !file.isSet())) {
        output.fail("needs one INPUT.rawlog and --output CAM.ini");
    }
    status = output.failed() ? usage_status : 0;
    if (!parsed || output.failed()) return std::nullopt;
    CommandLine result;
    result.quiet = quiet.getValue();
    result.options.input = input;
    result.options.output = file.getValue();
    result.options.picture = picture.getValue();
    result.options.config = cli::configuration(config.getValue(), settings.getValue());
    result.options.odometry = odometry.getValue();
    if (!result.quiet) result.options.progress = cli::Progress::style_for(std::cout);
    return result;
}

}  // namespace

int run_calibrate_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    try {
        int status = 0;
        const auto command = parse(arguments, out, error, status);
        if (!command) return status;
        const calibration::CalibrationResult result = calibration::calibrate(command->options);
        if (!result.message.empty()) error << "flownav-calibrate: " << result.message << '\n';
        if (!command->quiet) {
            for (const calibration::CalibratedValue& value : result.values) out << describe(value) << '\n';
            for (const std::string& note : result.notes) out << note << '\n';
            if (!result.values.empty()) out << "see " << command->options.output.string() << '\n';
        }
        return static_cast<int>(result.status);
    } catch (const config::ConfigError& exception) {
        error << "flownav-calibrate: " << exception.what() << '\n';
        return usage_status;
    }
}

}  // namespace flownav
