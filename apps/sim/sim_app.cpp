#include "sim_app.h"

#include <chrono>
#include <cmath>
#include <future>
#include <iostream>
#include <ostream>

#include "flownav/cli/exit_status.h"
#include "flownav/cli/progress.h"
#include "flownav/config/config_value.h"
#include "flownav/io/drive_recording.h"
#include "flownav/io/output_file.h"
#include "flownav/sim/collision.h"
#include "flownav/sim/ground.h"
#include "flownav/sim/sdf_world.h"
#include "sim_options.h"

namespace flownav {
namespace {

int images_of(const SimOptions& options) {
    return static_cast<int>(std::floor(options.path->end_s() * options.camera.rate_hz + 1e-6)) + 1;
}

/// Names the object that the robot collides with, or the edge it is over; empty when it is free.
std::string contact(const SimOptions& options, const Pose2& pose, double time_s) {
    const RobotModel robot;
    const sim::Clearance clear = sim::clearance(options.world, robot, pose, time_s);
    if (clear.distance_m <= 0.0) return "through " + clear.nearest;
    const auto edge = sim::overhang(options.world, robot.footprint_m, pose);
    return edge ? "over an edge of " + config::format_number(edge->depth_m) + " m" : "";
}

void warn_of(const std::string& touched, double time_s, std::ostream& error) {
    error << "flownav-sim: warning: after " << time_s << " s the path goes " << touched << '\n';
}

void record(const SimOptions& options, cli::Progress& progress, std::ostream& error) {
    io::DriveRecording recording(options.output);
    sim::CameraSimulator camera(options.world, options.camera);
    sim::WheelOdometry wheels(options.odometry);
    const int images = images_of(options);
    std::string touched;
    std::future<void> writing;  // writes one image while the next one is rendered
    for (int i = 0; i < images; ++i) {
        const double time_s = i / options.camera.rate_hz;
        const Pose2 pose = options.path->at(time_s);
        const Field field = camera.take(i, pose, time_s);
        const Pose2 odometry = wheels.update(pose);
        if (writing.valid()) writing.get();
        const Eigen::Isometry3d T_flat_robot = sim::ride_on_ground(options.world, pose);
        writing = std::async(std::launch::async, [&recording, field, odometry, pose, T_flat_robot] {
            recording.write_odometry(field.timestamp_s, odometry);
            recording.write_truth(field.timestamp_s, pose, T_flat_robot);
            recording.write(field);
        });
        if (touched.empty()) {
            touched = contact(options, pose, time_s);
            if (!touched.empty()) warn_of(touched, time_s, error);
        }
        progress.update(static_cast<double>(i + 1) / images, static_cast<std::uint64_t>(i) + 1U);
    }
    writing.get();
    recording.complete();
}

void run(const SimOptions& options, std::ostream& out, std::ostream& error) {
    for (const std::string& warning : options.warnings) error << "flownav-sim: warning: " << warning << '\n';
    if (!options.write_world.empty()) {
        io::write_file(options.write_world, sim::to_sdf(options.world));
        if (!options.quiet)
            out << options.write_world.string() << ": " << options.world.solids.size() << " solids\n";
    }
    if (!options.path) return;
    cli::Progress progress(
        std::cout, options.quiet ? cli::Progress::Style::Silent : cli::Progress::style_for(std::cout));
    const auto begin = std::chrono::steady_clock::now();
    record(options, progress, error);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    const int images = images_of(options);
    progress.finish(static_cast<std::uint64_t>(images));
    if (options.quiet) return;
    const double drive_s = images / options.camera.rate_hz;
    const double times = std::round(10.0 * drive_s / std::max(took.count(), 1e-3)) / 10.0;
    out << options.output.string() << ": " << images << " images of " << std::round(10.0 * drive_s) / 10.0
        << " s, recorded at " << times << " times real time\n";
}

}  // namespace

int run_sim_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    const auto fail = [&error](const std::exception& exception, cli::ExitStatus status) {
        error << "flownav-sim: " << exception.what() << '\n';
        return cli::exit_code(status);
    };
    try {
        int status = 0;
        const auto options = parse_sim_options(arguments, out, error, status);
        if (options) run(*options, out, error);
        return status;
    } catch (const io::OutputError& exception) {
        return fail(exception, cli::ExitStatus::Output);
    } catch (const sim::WorldError& exception) {
        return fail(exception, cli::ExitStatus::Input);
    } catch (const sim::PathError& exception) {
        return fail(exception, cli::ExitStatus::Input);
    } catch (const std::exception& exception) {
        return fail(exception, cli::ExitStatus::Usage);
    }
}

}  // namespace flownav
