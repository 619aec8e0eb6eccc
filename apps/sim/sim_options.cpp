#include "sim_options.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "flownav/cli/command_output.h"
#include "flownav/cli/configuration.h"
#include "flownav/config/config_value.h"
#include "flownav/core/version.h"
#include "flownav/math/units.h"
#include "flownav/sim/drive_script.h"
#include "flownav/sim/generate_world.h"
#include "flownav/sim/sdf_world.h"
#include "flownav/sim/world_look.h"
#include "sim_help.h"

namespace flownav {
namespace {

using Text = TCLAP::ValueArg<std::string>;
using Number = TCLAP::ValueArg<double>;

constexpr double longest_s = 86400.0;

/// The arguments as TCLAP options.
struct Arguments {
    explicit Arguments(TCLAP::CmdLine& c) : command(c) {}

    TCLAP::CmdLine& command;
    TCLAP::UnlabeledMultiArg<std::string> worlds{"world", "", false, "WORLD.world", command};
    Text generate{"", "generate", "", false, "", "KIND", command};
    TCLAP::ValueArg<int> seed{"", "seed", "", false, 1, "N", command};
    Text objects{"", "objects", "", false, "", "WORD", command};
    Text floor{"", "floor", "", false, "", "WORD", command};
    Text write_world{"", "write-world", "", false, "", "F.world", command};
    Text path{"", "path", "", false, "", "FILE.csv", command};
    Text script{"", "script", "", false, "", "STEPS", command};
    Number speed{"", "speed", "", false, 0.4, "MPS", command};
    Number turn{"", "turn-degps", "", false, 30.0, "DEGPS", command};
    Text output{"", "output", "", false, "", "F.rawlog", command};
    Text camera{"", "camera", "", false, "", "FILE.ini", command};
    TCLAP::MultiArg<std::string> settings{"", "set", "", false, "camera.key=value", command};
    Text height{"", "height-m", "", false, "", "H", command};
    Text pitch{"", "pitch-deg", "", false, "", "P", command};
    TCLAP::ValueArg<int> width_px{"", "width", "", false, 640, "PX", command};
    TCLAP::ValueArg<int> height_px{"", "height", "", false, 480, "PX", command};
    Number fov{"", "fov-deg", "", false, 55.0, "D", command};
    Number rate{"", "rate", "", false, 25.0, "HZ", command};
    TCLAP::SwitchArg interlaced{"", "interlaced", "", command};
    Number noise{"", "noise", "", false, 2.5, "GREY", command};
    Number vibration{"", "vibration-deg", "", false, 0.0, "D", command};
    Number exposure_step{"", "exposure-step", "", false, 0.0, "S", command};
    Number vignetting{"", "vignetting", "", false, 0.0, "S", command};
    Number blur{"", "blur-px", "", false, 0.0, "PX", command};
    Number wheel_scale{"", "wheel-scale", "", false, 1.006, "S", command};
    Number wheel_turn_scale{"", "wheel-turn-scale", "", false, 1.01, "S", command};
    Number wheel_noise{"", "wheel-noise", "", false, 1.0, "F", command};
    TCLAP::SwitchArg quiet{"", "quiet", "", command};
};

template <class Number>
Number in_range(TCLAP::ValueArg<Number>& argument, Number low, Number high) {
    if (argument.getValue() >= low && argument.getValue() <= high) return argument.getValue();
    const auto text = [](Number value) { return config::format_number(static_cast<double>(value)); };
    throw config::ConfigError("--" + argument.getName() + ' ' + text(argument.getValue()) + ": must be " +
                              text(low) + ".." + text(high));
}

std::uint64_t seed_of(Arguments& a) {
    return static_cast<std::uint64_t>(in_range(a.seed, 0, std::numeric_limits<int>::max()));
}

/// Describes missing or contradictory arguments; empty when they are valid.
std::string complaint(Arguments& a) {
    for (const std::string& word : a.worlds.getValue())
        if (word.rfind('-', 0) == 0) return "there is no option " + word;
    const std::size_t worlds = a.worlds.getValue().size() + (a.generate.isSet() ? 1 : 0);
    if (worlds != 1) return "needs one world: a file, or --generate KIND";
    if (a.path.isSet() && a.script.isSet()) return "give --path or --script, not both";
    const bool drives = a.path.isSet() || a.script.isSet();
    if (drives != a.output.isSet())
        return drives ? "needs --output F.rawlog" : "needs --path FILE.csv or --script STEPS for a recording";
    if (!drives && !a.write_world.isSet()) return "needs --path or --script and --output, or --write-world";
    return "";
}

template <class Items, class Name>
auto named(const std::string& option, const std::string& word, const Items& items, const Name& name_of) {
    std::string known;
    for (const auto& item : items) {
        if (word == name_of(item)) return item;
        known += std::string(known.empty() ? "" : ", ") + name_of(item);
    }
    throw config::ConfigError("--" + option + ' ' + word + ": is none of " + known);
}

const char* word_of(sim::WorldKind kind) {
    return to_string(kind);
}

/// Generated worlds look like real rooms unless told otherwise; others look as their file says.
void set_looks(Arguments& a, sim::World& world) {
    using Look = sim::ObjectLook;
    constexpr std::array<Look, 4> looks = {Look::Real, Look::Patterned, Look::Faint, Look::Plain};
    const std::string word = a.objects.getValue();
    if (a.objects.isSet() || a.generate.isSet()) {
        const auto word_of_look = [](Look look) { return to_string(look); };
        set_objects(world, word.empty() ? Look::Real : named("objects", word, looks, word_of_look),
                    seed_of(a));
    }
    if (!a.floor.isSet()) return;
    const auto word_of_floor = [](const auto& floor) { return floor.first; };
    world.floor.surface = named("floor", a.floor.getValue(), sim::floor_surfaces(), word_of_floor).second;
}

void take_world(Arguments& a, SimOptions& options) {
    if (a.generate.isSet()) {
        const sim::WorldKind kind = named("generate", a.generate.getValue(), sim::all_world_kinds, word_of);
        options.world = sim::generate_world(kind, seed_of(a));
    } else {
        sim::LoadedWorld loaded = sim::read_sdf_world(a.worlds.getValue().front());
        options.world = std::move(loaded.world);
        options.warnings = std::move(loaded.warnings);
    }
    set_looks(a, options.world);
    const RobotModel robot;
    if (options.world.shadow_light)
        options.world.shadow_light->robot = sim::ShadowBody{robot.footprint_m, robot.height_m};
}

std::optional<sim::TimedPath> path_of(Arguments& a, const Pose2& start) {
    const sim::PathSpeed speed{in_range(a.speed, 0.01, 5.0), in_range(a.turn, 0.1, 180.0) * degree_rad};
    if (a.path.isSet()) {
        const auto given = a.speed.isSet() ? std::make_optional(speed) : std::nullopt;
        sim::TimedPath path = sim::read_path(a.path.getValue(), given);
        if (path.end_s() <= longest_s) return path;
        throw sim::PathError(a.path.getValue() + ": lasts " + config::format_number(path.end_s()) +
                             " s; a recording may last a day");
    }
    if (!a.script.isSet()) return std::nullopt;
    RobotModel robot;
    robot.v_max_mps = speed.v_mps;
    robot.v_back_mps = speed.v_mps;
    robot.omega_max_radps = 2 * speed.omega_radps;  // a script starts at half of this
    try {
        return sim::drive_script(a.script.getValue(), robot, start);
    } catch (const sim::PathError& error) {
        throw config::ConfigError(error.what());  // reported as an error of the command line, not of a file
    }
}

/// Value of a camera key: from the option, the ini, or the default.
double camera_value(Text& option, const std::string& key, std::optional<double> config::CameraConfig::*member,
                    config::Config& config, double otherwise) {
    if (option.isSet()) config::set_config_value(config, key, option.getValue());
    return (config.camera.*member).value_or(otherwise);
}

CameraModel camera_model_of(Arguments& a) {
    config::Config config = cli::configuration(a.camera.getValue(), a.settings.getValue());
    CameraModel camera;
    camera.width_px = a.interlaced.getValue() && !a.width_px.isSet() ? 768 : in_range(a.width_px, 64, 4096);
    camera.height_px =
        a.interlaced.getValue() && !a.height_px.isSet() ? 576 : in_range(a.height_px, 48, 4096);
    const double half_rad = in_range(a.fov, 10.0, 140.0) / 2 * degree_rad;
    const config::CameraConfig& ini = config.camera;
    camera.fx_px = ini.fx_px.value_or(camera.width_px / 2.0 / std::tan(half_rad));
    camera.fy_px = ini.fy_px.value_or(camera.fx_px);
    camera.cx_px = ini.cx_px.value_or((camera.width_px - 1) / 2.0);
    camera.cy_px = ini.cy_px.value_or((camera.height_px - 1) / 2.0);
    if (ini.distortion) {
        camera.distortion = *ini.distortion;
        camera.lens = &find_lens(ini.lens);
    }
    camera.mount.height_m =
        camera_value(a.height, "camera.height_m", &config::CameraConfig::height_m, config, 0.9);
    camera.mount.pitch_rad =
        camera_value(a.pitch, "camera.pitch_deg", &config::CameraConfig::pitch_deg, config, 25.0) *
        degree_rad;
    camera.mount.roll_rad = ini.roll_deg.value_or(0.0) * degree_rad;
    camera.mount.yaw_rad = ini.yaw_deg.value_or(0.0) * degree_rad;
    camera.mount.forward_m = ini.forward_m.value_or(0.0);
    camera.mount.left_m = ini.left_m.value_or(0.0);
    return camera;
}

SimOptions options_of(Arguments& a) {
    SimOptions options;
    options.output = a.output.getValue();
    options.write_world = a.write_world.getValue();
    options.quiet = a.quiet.getValue();
    options.camera.camera = camera_model_of(a);
    options.camera.interlaced = a.interlaced.getValue();
    options.camera.rate_hz =
        a.interlaced.getValue() && !a.rate.isSet() ? 50.0 : in_range(a.rate, 1.0, 1000.0);
    options.camera.effects.noise_sigma = in_range(a.noise, 0.0, 50.0);
    options.camera.effects.pitch_vibration_deg = in_range(a.vibration, 0.0, 5.0);
    options.camera.effects.exposure_step = in_range(a.exposure_step, 0.0, 0.9);
    options.camera.effects.vignetting = in_range(a.vignetting, 0.0, 0.9);
    options.camera.effects.blur_px = in_range(a.blur, 0.0, 10.0);
    options.camera.effects.seed = seed_of(a);
    options.odometry.scale = in_range(a.wheel_scale, 0.5, 2.0);
    options.odometry.turn_scale = in_range(a.wheel_turn_scale, 0.5, 2.0);
    options.odometry.way_noise_m *= in_range(a.wheel_noise, 0.0, 100.0);
    options.odometry.turn_noise_rad *= a.wheel_noise.getValue();
    options.odometry.seed = seed_of(a);
    take_world(a, options);
    options.path = path_of(a, options.world.start);
    return options;
}

}  // namespace

std::optional<SimOptions> parse_sim_options(const std::vector<std::string>& arguments, std::ostream& out,
                                            std::ostream& error, int& status) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-sim", sim_help, out, error);
    const auto args = std::make_unique<Arguments>(command);
    status = 0;
    if (!cli::parse_arguments(command, arguments)) {
        status = output.failed() ? 1 : 0;
        return std::nullopt;
    }
    const std::string wrong = complaint(*args);
    if (wrong.empty()) return options_of(*args);
    output.fail(wrong);
    status = 1;
    return std::nullopt;
}

}  // namespace flownav
