// The experiment of [P], section 5, in simulation: along a railing, round a chair, and back to the railing.
#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <cmath>
#include <filesystem>
#include <iostream>

#include "flownav/cli/number_text.h"
#include "flownav/core/version.h"
#include "flownav/drive/simulated_drive.h"
#include "flownav/io/output_file.h"
#include "flownav/math/units.h"
#include "flownav/sim/sdf_world.h"
#include "svg_chart.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

constexpr report::Colour truth_colour = report::palette::black;
constexpr report::Colour flow_colour = report::palette::blue;
constexpr report::Colour wheels_colour = report::palette::vermilion;
constexpr report::Colour thing_colour = report::palette::grey;

/// Records both kinds of odometry during the drive; each starts at the identity.
struct Tracks : drive::DriveObserver {
    struct Stamped {
        double time_s;
        Pose2 pose;
    };
    std::vector<Stamped> truth, flow, wheels;

    void on_field(const Field& field, const pipeline::Step& step) override {
        flow.push_back({field.timestamp_s, step.T_start_robot});
    }
    void on_odometry(double timestamp_s, const Pose2& pose) override {
        wheels.push_back({timestamp_s, pose});
    }
    void on_truth(double timestamp_s, const Pose2& pose, const Eigen::Isometry3d&) override {
        truth.push_back({timestamp_s, pose});
    }
};

/// Transforms a track to the frame of its first pose.
std::vector<Tracks::Stamped> from_start(std::vector<Tracks::Stamped> track) {
    const Pose2 T_start_world = inverse(track.front().pose);
    for (Tracks::Stamped& sample : track) sample.pose = compose(T_start_world, sample.pose);
    return track;
}

ChartSeries plan_of(const std::string& name, const report::Colour& colour,
                    const std::vector<Tracks::Stamped>& track) {
    ChartSeries series{name, colour, {{}}};
    for (const auto& [time_s, pose] : track) series.pieces[0].emplace_back(pose.x_m, pose.y_m);
    series.pieces[0] = thinned(series.pieces[0], 800);
    return series;
}

ChartSeries heading_of(const std::string& name, const report::Colour& colour,
                       const std::vector<Tracks::Stamped>& track) {
    ChartSeries series{name, colour, {{}}};
    double heading_rad = 0.0;  // unwrapped
    for (const auto& [time_s, pose] : track) {
        heading_rad += wrap_angle(pose.yaw_rad - heading_rad);
        series.pieces[0].emplace_back(time_s - track.front().time_s, deg(heading_rad));
    }
    series.pieces[0] = thinned(series.pieces[0], 800);
    return series;
}

/// Outlines of the obstacles in the frame of the start.
ChartSeries things(const sim::World& world, const Pose2& start) {
    ChartSeries series{"railing and chair", thing_colour, {}};
    for (const sim::Solid& solid : world.solids) {
        const Eigen::Isometry3d& pose = solid.T_world_solid;
        std::vector<Vector2d> outline;
        const auto add = [&](double x, double y) {
            outline.push_back(transform(inverse(start), (pose * Eigen::Vector3d(x, y, 0.0)).head<2>()));
        };
        if (const auto* box = std::get_if<sim::Box>(&solid.shape)) {
            const double x = box->size_m.x() / 2;
            const double y = box->size_m.y() / 2;
            for (const auto& [sx, sy] : {std::pair{x, y}, {-x, y}, {-x, -y}, {x, -y}, {x, y}}) add(sx, sy);
        } else if (const auto* cylinder = std::get_if<sim::Cylinder>(&solid.shape)) {
            for (int i = 0; i <= 12; ++i) {
                const double angle = i * M_PI / 6;
                add(cylinder->radius_m * std::cos(angle), cylinder->radius_m * std::sin(angle));
            }
        }
        if (!outline.empty()) series.pieces.push_back(outline);
    }
    return series;
}

struct Figures {
    drive::DriveResult result;
    double flow_error_percent = 0.0;
    double wheels_error_percent = 0.0;
    double flow_heading_deg = 0.0;
    double wheels_heading_deg = 0.0;
};

drive::SimulatedDriveOptions experiment(const std::string& world, const config::Config& config,
                                        double way_m) {
    drive::SimulatedDriveOptions options;
    options.world = sim::read_sdf_world(world).world;
    options.start = options.world.start;
    options.config = config;
    options.config.recovery.replan = nav::ReplanPolicy::Never;
    options.waypoint_robot_m = Vector2d(5.0, 2.0);  // [P]: "unreachable goal on the left"
    options.way_max_m = way_m;
    options.timeout_s = 4.0 * way_m / config.navigation.robot.v_max_mps;
    CameraModel& camera = options.camera.camera;  // the camera of [P]: PAL fields, 55 degrees wide
    camera.width_px = 768;
    camera.height_px = 576;
    camera.fx_px = camera.fy_px = 384.0 / std::tan(27.5 * degree_rad);
    camera.cx_px = 383.5;
    camera.cy_px = 287.5;
    camera.mount.height_m = config.camera.height_m.value_or(0.9);
    camera.mount.pitch_rad = config.camera.pitch_deg.value_or(25.0) * degree_rad;
    options.camera.interlaced = true;
    options.camera.rate_hz = 50.0;
    options.camera.effects.noise_sigma = 2.5;
    return options;
}

double error_percent(const std::vector<Tracks::Stamped>& track, const Pose2& truth, double way_m) {
    const Pose2 end = track.back().pose;
    return 100.0 * std::hypot(end.x_m - truth.x_m, end.y_m - truth.y_m) / way_m;
}

double heading_error_deg(const std::vector<Tracks::Stamped>& track, const Pose2& truth) {
    return deg(wrap_angle(track.back().pose.yaw_rad - truth.yaw_rad));
}

Figures run(const drive::SimulatedDriveOptions& options, const std::string& name,
            const std::filesystem::path& folder) {
    Tracks tracks;
    Figures figures;
    figures.result = drive::simulate_drive(options, tracks);
    const auto truth = from_start(tracks.truth);
    const auto flow = from_start(tracks.flow);
    auto wheels = from_start(tracks.wheels);
    while (wheels.size() > 1 && wheels.back().time_s > truth.back().time_s + 1e-6) wheels.pop_back();
    const Pose2 end = truth.back().pose;
    const double way_m = figures.result.path_m;
    figures.flow_error_percent = error_percent(flow, end, way_m);
    figures.wheels_error_percent = error_percent(wheels, end, way_m);
    figures.flow_heading_deg = heading_error_deg(flow, end);
    figures.wheels_heading_deg = heading_error_deg(wheels, end);
    Chart plan;
    plan.title = "Way of the robot, " + name;
    plan.x_label = "x (m)";
    plan.y_label = "y (m)";
    plan.equal_scales = true;
    plan.series = {things(options.world, options.start), plan_of("wheels", wheels_colour, wheels),
                   plan_of("truth", truth_colour, truth), plan_of("optic flow", flow_colour, flow)};
    plan.series[3].dashed = true;
    Chart heading;
    heading.title = "Heading, " + name;
    heading.x_label = "time (s)";
    heading.y_label = "heading (deg)";
    heading.series = {heading_of("wheels", wheels_colour, wheels), heading_of("truth", truth_colour, truth),
                      heading_of("optic flow", flow_colour, flow)};
    heading.series[2].dashed = true;
    io::write_file(folder / ("railing-" + name + "-way.svg"), svg_file(plan));
    io::write_file(folder / ("railing-" + name + "-heading.svg"), svg_file(heading));
    return figures;
}

std::string row(const std::string& name, const Figures& f) {
    return "| " + name + " | " + to_string(f.result.outcome) + " | " + cli::fixed_text(f.result.path_m, 1) +
           " | " + cli::fixed_text(f.result.time_s, 1) + " | " +
           cli::fixed_text(f.result.min_clearance_m, 2) + " | " + cli::fixed_text(f.flow_error_percent, 2) +
           " | " + cli::fixed_text(f.flow_heading_deg, 2) + " | " +
           cli::fixed_text(f.wheels_error_percent, 2) + " | " + cli::fixed_text(f.wheels_heading_deg, 2) +
           " |\n";
}

int experiment_app(int argc, char** argv) {
    TCLAP::CmdLine command("The railing and the chair of the paper, with both navigators", ' ', version());
    TCLAP::ValueArg<std::string> world("", "world", "the world", false, FLOWNAV_RAILING_WORLD, "FILE.world",
                                       command);
    TCLAP::ValueArg<std::string> folder("", "output", "where table and pictures go", true, "", "DIR",
                                        command);
    TCLAP::ValueArg<double> way("", "way-m", "length of the drive", false, 18.0, "M", command);
    if (!command.parse(argc, argv)) return 0;
    io::make_output_folder(folder.getValue());
    std::string table =
        "| navigator | outcome | way (m) | time (s) | nearest (m) | flow: end (% of way) | heading (deg) | "
        "wheels: end (% of way) | heading (deg) |\n|---|---|---|---|---|---|---|---|---|\n";
    for (const char* name : {"lanes", "reactive"}) {
        config::Config config;
        config.navigation.navigator = name;
        const Figures figures =
            run(experiment(world.getValue(), config, way.getValue()), name, folder.getValue());
        table += row(name, figures);
        std::cout << name << ": " << to_string(figures.result.outcome) << ' ' << figures.result.why << '\n';
    }
    std::cout << table;
    io::write_file(std::filesystem::path(folder.getValue()) / "railing-table.md", table);
    return 0;
}

}  // namespace
}  // namespace flownav

int main(int argc, char** argv) {
    try {
        return flownav::experiment_app(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "flownav-railing: " << error.what() << '\n';
        return 1;
    }
}
