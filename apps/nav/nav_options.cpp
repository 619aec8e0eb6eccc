#include "nav_options.h"

#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "flownav/cli/command_output.h"
#include "flownav/cli/configuration.h"
#include "flownav/config/config_value.h"
#include "flownav/core/version.h"
#include "flownav/math/units.h"
#include "flownav/nav/tcp_robot.h"
#include "flownav/sim/generate_world.h"
#include "flownav/sim/sdf_world.h"
#include "flownav/sim/world_look.h"

namespace flownav {
namespace {

using Eigen::Vector2d;
using Text = TCLAP::ValueArg<std::string>;
using Number = TCLAP::ValueArg<double>;

std::vector<double> numbers(Text& argument, char separator, std::size_t count) {
    std::vector<double> values;
    std::stringstream text(argument.getValue());
    for (std::string part; std::getline(text, part, separator);) {
        try {
            values.push_back(config::parse_number<double>(part));
        } catch (const config::BadValue&) {
            values.clear();
            break;
        }
    }
    if (values.size() == count) return values;
    throw config::ConfigError("--" + argument.getName() + ' ' + argument.getValue() + ": needs the form " +
                              argument.getDescription());
}

/// Throws ConfigError unless low <= value <= high.
template <class T>
T in_range(TCLAP::ValueArg<T>& argument, T low, T high) {
    if (argument.getValue() >= low && argument.getValue() <= high) return argument.getValue();
    throw config::ConfigError("--" + argument.getName() + ' ' + config::format_number(argument.getValue()) +
                              ": is out of range; allowed: " + config::describe(config::Range<T>{low, high}));
}

std::vector<Vector2d> read_waypoints(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot open the way points " + path);
    std::vector<Vector2d> points;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        line = line.substr(0, line.find('#'));
        for (char& letter : line)
            if (letter == ',') letter = ' ';
        std::istringstream words(line);
        double x = 0.0;
        double y = 0.0;
        std::string rest;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        if (!(words >> x >> y) || words >> rest || !std::isfinite(x) || !std::isfinite(y))
            throw std::runtime_error(path + ", line " + std::to_string(number) + ": needs two numbers, x y");
        points.emplace_back(x, y);
    }
    if (points.empty()) throw std::runtime_error(path + ": holds no way point");
    return points;
}

template <class T>
T one_of(const std::string& option, const std::string& word,
         const std::vector<std::pair<std::string, T>>& known) {
    std::string words;
    for (const auto& [name, value] : known) {
        if (name == word) return value;
        words += (words.empty() ? "" : ", ") + name;
    }
    throw config::ConfigError("--" + option + ' ' + word + ": is none of " + words);
}

/// The arguments as TCLAP sees them.
struct Arguments {
    explicit Arguments(TCLAP::CmdLine& c) : command(c) {}

    TCLAP::CmdLine& command;
    Text robot{"", "robot", "", false, "sim", "ROBOT", command};
    Text camera{"", "camera", "", false, "", "CAM.ini", command};
    Text world{"", "world", "", false, "", "FILE.world", command};
    Text generate{"", "generate", "", false, "", "KIND", command};
    Text start{"", "start", "X,Y,YAW_DEG", false, "", "X,Y,YAW_DEG", command};
    Text goal{"", "goal", "X,Y", false, "", "X,Y", command};
    Text waypoints{"", "waypoints", "", false, "", "FILE", command};
    Text follow{"", "follow", "X,Y", false, "", "X,Y", command};
    Number way_max{"", "way-max-m", "", false, 1e6, "M", command};
    Number success_radius{"", "success-radius-m", "", false, 0.5, "M", command};
    Number timeout{"", "timeout-s", "", false, 120.0, "S", command};
    Text navigator{"", "navigator", "", false, "", "NAME", command};
    Text sensor{"", "sensor", "", false, "flow", "flow|lidar", command};
    Text config{"", "config", "", false, "", "FILE.ini", command};
    TCLAP::MultiArg<std::string> settings{"", "set", "", false, "section.key=value", command};
    TCLAP::ValueArg<int> seed{"", "seed", "", false, 1, "N", command};
    TCLAP::ValueArg<int> width{"", "width", "", false, 640, "PX", command};
    TCLAP::ValueArg<int> height{"", "height", "", false, 480, "PX", command};
    Number fov{"", "fov-deg", "", false, 90.0, "D", command};
    Number rate{"", "rate", "", false, 25.0, "HZ", command};
    TCLAP::SwitchArg interlaced{"", "interlaced", "", command};
    Number noise{"", "noise", "", false, 2.0, "GREY", command};
    TCLAP::ValueArg<int> supersampling{"", "supersampling", "", false, 2, "N", command};
    Number vibration{"", "vibration-deg", "", false, 0.0, "D", command};
    Text objects{"", "objects", "", false, "", "WORD", command};
    Text floor{"", "floor", "", false, "", "WORD", command};
    Text output{"", "output", "", false, "", "DIR", command};
    Text result{"", "result", "", false, "", "FILE.json", command};
    Text record{"", "record", "", false, "", "FILE.rawlog", command};
    Text picture{"", "picture", "", false, "", "FILE.png", command};
    Text navlog{"", "navlog", "", false, "", "DIR", command};
    Number reference_path{"", "reference-path-m", "", false, 0.0, "M", command};
    TCLAP::SwitchArg realtime{"", "realtime", "", command};
    TCLAP::SwitchArg quiet{"", "quiet", "", command};
};

std::uint64_t seed_of(Arguments& a) {
    return static_cast<std::uint64_t>(in_range(a.seed, 0, std::numeric_limits<int>::max()));
}

sim::World make_world(Arguments& a, std::ostream& error) {
    if (a.world.isSet() == a.generate.isSet())
        throw config::ConfigError("needs either --world or --generate");
    if (a.generate.isSet()) {
        std::vector<std::pair<std::string, sim::WorldKind>> kinds;
        for (const sim::WorldKind kind : sim::all_world_kinds) kinds.emplace_back(to_string(kind), kind);
        return sim::generate_world(one_of<sim::WorldKind>("generate", a.generate.getValue(), kinds),
                                   seed_of(a));
    }
    sim::LoadedWorld loaded = sim::read_sdf_world(a.world.getValue());
    for (const std::string& warning : loaded.warnings) error << "flownav-nav: warning: " << warning << '\n';
    return std::move(loaded.world);
}

/// The camera of the command line, on the mount of the configuration.
sim::CameraSimParams make_camera(Arguments& a, const config::CameraConfig& config) {
    sim::CameraSimParams params;
    params.interlaced = a.interlaced.getValue();
    CameraModel& camera = params.camera;
    const bool pal = params.interlaced;
    camera.width_px = pal && !a.width.isSet() ? 768 : in_range(a.width, 64, 4096);
    camera.height_px = pal && !a.height.isSet() ? 576 : in_range(a.height, 48, 4096);
    const double half_rad = in_range(a.fov, 10.0, 140.0) / 2 * degree_rad;
    camera.fx_px = config.fx_px.value_or(camera.width_px / 2.0 / std::tan(half_rad));
    camera.fy_px = config.fy_px.value_or(camera.fx_px);
    camera.cx_px = config.cx_px.value_or((camera.width_px - 1) / 2.0);
    camera.cy_px = config.cy_px.value_or((camera.height_px - 1) / 2.0);
    if (config.distortion) {
        camera.distortion = *config.distortion;
        camera.lens = &find_lens(config.lens);
    }
    camera.mount.height_m = config.height_m.value_or(0.5);
    camera.mount.pitch_rad = config.pitch_deg.value_or(20.0) * degree_rad;
    camera.mount.roll_rad = config.roll_deg.value_or(0.0) * degree_rad;
    camera.mount.yaw_rad = config.yaw_deg.value_or(0.0) * degree_rad;
    camera.mount.forward_m = config.forward_m.value_or(0.0);
    camera.mount.left_m = config.left_m.value_or(0.0);
    params.rate_hz = pal && !a.rate.isSet() ? 50.0 : in_range(a.rate, 1.0, 200.0);
    params.supersampling = in_range(a.supersampling, 1, 4);
    params.effects.noise_sigma = in_range(a.noise, 0.0, 50.0);
    params.effects.pitch_vibration_deg = in_range(a.vibration, 0.0, 5.0);
    params.effects.seed = seed_of(a);
    return params;
}

void set_goals(Arguments& a, drive::SimulatedDriveOptions& drive) {
    drive.start = drive.world.start;
    if (a.start.isSet()) {
        const auto start = numbers(a.start, ',', 3);
        drive.start = {start[0], start[1], start[2] * degree_rad};
    }
    if (a.follow.isSet()) {
        const auto point = numbers(a.follow, ',', 2);
        drive.waypoint_robot_m = Vector2d(point[0], point[1]);
        return;
    }
    if (a.waypoints.isSet()) drive.goals_m = read_waypoints(a.waypoints.getValue());
    if (a.goal.isSet()) {
        const auto goal = numbers(a.goal, ',', 2);
        drive.goals_m.emplace_back(goal[0], goal[1]);
    } else if (drive.world.goal && drive.goals_m.empty()) {
        drive.goals_m.push_back(*drive.world.goal);
    }
    if (drive.goals_m.empty())
        throw config::ConfigError("needs --goal X,Y, --waypoints FILE or --follow X,Y");
}

/// What only the simulation knows must not be ignored in silence.
void refuse_simulation_options(Arguments& a) {
    const std::initializer_list<TCLAP::Arg*> simulated = {
        &a.world,   &a.generate, &a.success_radius, &a.sensor,     &a.seed,         &a.width,
        &a.height,  &a.fov,      &a.rate,           &a.interlaced, &a.noise,        &a.vibration,
        &a.objects, &a.floor,    &a.reference_path, &a.realtime,   &a.supersampling};
    for (const TCLAP::Arg* argument : simulated) {
        if (argument->isSet())
            throw config::ConfigError("--" + argument->getName() + ": only with --robot sim");
    }
}

/// The robot: simulated, or a base on TCP with the camera of --camera.
void read_robot(Arguments& a, NavOptions& options) {
    options.robot = a.robot.getValue();
    options.seed = seed_of(a);
    if (options.robot != "sim") {
        refuse_simulation_options(a);
        nav::parse_tcp_address(options.robot);
        if (!a.camera.isSet())
            throw config::ConfigError("--robot " + options.robot + ": needs --camera CAM.ini");
        options.camera = io::read_producer_settings(a.camera.getValue());
    } else if (a.camera.isSet()) {
        throw config::ConfigError(
            "--camera: only with --robot tcp:HOST:PORT; the simulated robot has its own camera");
    }
}

/// The configuration of the camera's ini, then of --config, --set and --navigator.
void read_configuration(Arguments& a, NavOptions& options) {
    drive::SimulatedDriveOptions& drive = options.drive;
    const config::Config base = options.camera ? options.camera->config : config::Config{};
    drive.config = cli::configuration(a.config.getValue(), a.settings.getValue(), base);
    if (a.navigator.isSet())
        config::set_config_value(drive.config, "navigation.navigator", a.navigator.getValue());
    drive.sensor =
        one_of<drive::SensorKind>("sensor", a.sensor.getValue(),
                                  {{"flow", drive::SensorKind::Flow}, {"lidar", drive::SensorKind::Lidar}});
    config::check_navigation(drive.config);
    if (options.camera) {
        options.camera->config = drive.config;
    } else {
        drive.camera = make_camera(a, drive.config.camera);
    }
}

/// When a drive ends, and the simulated sensors.
void read_drive(Arguments& a, NavOptions& options) {
    drive::SimulatedDriveOptions& drive = options.drive;
    drive.success_radius_m = in_range(a.success_radius, 0.01, 100.0);
    drive.timeout_s = in_range(a.timeout, 1.0, 1e6);
    drive.way_max_m = in_range(a.way_max, 0.1, 1e6);
    drive.odometry.seed = options.seed;
    drive.lidar.beams = 271;
    drive.lidar.rate_hz = 10.0;
    drive.navlog_directory = a.navlog.getValue();
    drive.realtime = a.realtime.getValue();
}

void read_world(Arguments& a, drive::SimulatedDriveOptions& drive, std::ostream& error) {
    drive.world = make_world(a, error);
    if (a.objects.isSet() || a.generate.isSet()) {
        using Look = sim::ObjectLook;
        std::vector<std::pair<std::string, Look>> looks;
        for (const Look look : {Look::Real, Look::Patterned, Look::Faint, Look::Plain})
            looks.emplace_back(to_string(look), look);
        const std::string word = a.objects.isSet() ? a.objects.getValue() : to_string(Look::Real);
        set_objects(drive.world, one_of<Look>("objects", word, looks), seed_of(a));
    }
    if (a.floor.isSet())
        drive.world.floor.surface = one_of<sim::Surface>("floor", a.floor.getValue(), sim::floor_surfaces());
}

void read_outputs(Arguments& a, NavOptions& options) {
    options.output = a.output.getValue();
    options.result = a.result.getValue();
    options.record = a.record.getValue();
    options.picture = a.picture.getValue();
    options.reference_path_m = in_range(a.reference_path, 0.0, 1e6);
    options.quiet = a.quiet.getValue();
}

NavOptions options_of(Arguments& a, std::ostream& error) {
    NavOptions options;
    read_robot(a, options);
    read_configuration(a, options);
    read_drive(a, options);
    if (options.robot == "sim") read_world(a, options.drive, error);
    set_goals(a, options.drive);
    read_outputs(a, options);
    return options;
}

}  // namespace

std::optional<NavOptions> parse_nav_options(const std::vector<std::string>& arguments, std::ostream& out,
                                            std::ostream& error, int& status) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-nav", nav_help, out, error);
    Arguments parsed(command);
    if (!cli::parse_arguments(command, arguments)) {
        status = output.failed() ? 1 : 0;
        return std::nullopt;
    }
    return options_of(parsed, error);
}

}  // namespace flownav
