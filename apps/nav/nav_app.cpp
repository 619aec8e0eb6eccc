#include "nav_app.h"

#include <chrono>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "drive_files.h"
#include "drive_scene.h"
#include "flownav/cli/exit_status.h"
#include "flownav/cli/number_text.h"
#include "flownav/drive/camera_thread.h"
#include "flownav/drive/drive_recorder.h"
#include "flownav/io/output_file.h"
#include "flownav/nav/tcp_robot.h"
#include "flownav/replay/replay.h"
#include "nav_options.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;

int status_of(drive::Outcome outcome) {
    switch (outcome) {
        case drive::Outcome::Reached:
            return 0;
        case drive::Outcome::Blocked:
            return 4;
        case drive::Outcome::Collision:
        case drive::Outcome::Fell:
            return 5;
        case drive::Outcome::Timeout:
            return 6;
        case drive::Outcome::Stopped:
            return 7;
        case drive::Outcome::Lost:
            break;
    }
    return cli::exit_code(cli::ExitStatus::Input);
}

constexpr double progress_every_s = 10.0;

/// Hands what happens to the recorder, tells how far the drive is, and keeps the map.
class Onlooker : public drive::DriveObserver {
  public:
    Onlooker(drive::DriveRecorder& recorder, bool quiet, std::ostream& out)
        : recorder_(recorder), quiet_(quiet), out_(out) {}

    void on_field(const Field& field, const pipeline::Step& step) override {
        recorder_.on_field(field, step);
    }
    void on_odometry(double timestamp_s, const Pose2& pose) override {
        recorder_.on_odometry(timestamp_s, pose);
    }
    void on_truth(double timestamp_s, const Pose2& pose, const Eigen::Isometry3d& T_flat_robot) override {
        recorder_.on_truth(timestamp_s, pose, T_flat_robot);
    }
    void on_decision(const drive::DriveSample& sample, const nav::NavigationStack& stack) override {
        recorder_.on_decision(sample, stack);
        if (quiet_ || sample.time_s < next_progress_s_) return;
        const nav::RecoveryDecision& decision = stack.decision();
        out_ << cli::fixed_text(sample.time_s, 0) << " s: at " << cli::fixed_text(sample.T_map_robot.x_m, 1)
             << ' ' << cli::fixed_text(sample.T_map_robot.y_m, 1) << " m, " << to_string(decision.state)
             << (decision.why.empty() ? "" : ", " + decision.why) << std::endl;
        next_progress_s_ += progress_every_s;
    }
    void on_end(const nav::NavigationStack& stack) override { map_ = stack.map(); }

    const mrpt::maps::COccupancyGridMap2D& map() const { return map_; }

  private:
    drive::DriveRecorder& recorder_;
    bool quiet_;
    std::ostream& out_;
    double next_progress_s_ = progress_every_s;
    mrpt::maps::COccupancyGridMap2D map_;
};

void write_picture(const fs::path& file, const cv::Mat& picture) {
    std::vector<std::uint8_t> png;
    cv::imencode(".png", picture, png);
    io::write_file(file, {reinterpret_cast<const char*>(png.data()), png.size()});
}

/// Where --output puts what has no place of its own.
void complete(NavOptions& options) {
    if (options.output.empty()) return;
    io::make_output_folder(options.output);
    if (options.result.empty()) options.result = options.output / "result.json";
    if (options.picture.empty()) options.picture = options.output / "drive.png";
    if (options.record.empty() && options.drive.sensor == drive::SensorKind::Flow)
        options.record = options.output / "run.rawlog";
}

drive::DriveRecorderOptions recorder_options(const NavOptions& options) {
    drive::DriveRecorderOptions recorder;
    recorder.rawlog = options.record;
    if (!options.output.empty()) recorder.csv = options.output / "drive.csv";
    recorder.may_wait = options.robot == "sim";
    return recorder;
}

/// The sensor's own account of the drive, from the recording, whose fields carry their camera.
void report(const NavOptions& options) {
    if (options.output.empty() || options.record.empty()) return;
    replay::ReplayOptions replaying;
    replaying.input = options.record;
    replaying.output = options.output;
    replaying.config = options.drive.config;
    replaying.config.camera = config::CameraConfig{};
    const replay::ReplayResult result = replay::replay(replaying);
    if (result.status == cli::ExitStatus::Output) throw io::OutputError(result.message);
}

drive::DriveResult drive_simulated(const NavOptions& options, Onlooker& onlooker) {
    return drive::simulate_drive(options.drive, onlooker);
}

/// Its camera is opened before its motors are told anything. The base has been told `bye` afterwards.
drive::DriveResult drive_real(const NavOptions& options, Onlooker& onlooker) {
    drive::SteadyClock clock;
    nav::TcpRobotParams params;
    params.clock_s = [&clock] { return clock.now_s(); };
    nav::TcpRobot base(nav::parse_tcp_address(options.robot), params);
    drive::CameraThread camera(
        *options.camera, clock,
        [&onlooker](const Field& field, const pipeline::Step& step) { onlooker.on_field(field, step); });
    drive::DriveOptions driving = options.drive;
    driving.hung_s = driving.config.guard.watchdog_s;
    return drive::drive(driving, {clock, base, camera}, onlooker);
}

std::string closing_line(const NavOptions& options, const drive::DriveResult& result, double wall_s) {
    std::string line = to_string(result.outcome);
    if (!result.why.empty()) line += " (" + result.why + ')';
    line += ": " + cli::fixed_text(result.path_m, 2) + " m in " + cli::fixed_text(result.time_s, 1) + " s";
    if (options.robot != "sim") return line;
    return line + ", nearest " + cli::fixed_text(result.min_clearance_m, 2) + " m, " +
           cli::fixed_text(result.time_s / wall_s, 1) + " times real time";
}

int run_drive(NavOptions options, const StopRequest& stop, std::ostream& out, std::ostream& error) {
    complete(options);
    options.drive.stop_wanted = stop.wanted;
    drive::DriveRecorder recorder(recorder_options(options));
    Onlooker onlooker(recorder, options.quiet, out);
    const auto began = std::chrono::steady_clock::now();
    const drive::DriveResult result =
        options.robot == "sim" ? drive_simulated(options, onlooker) : drive_real(options, onlooker);
    const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    if (stop.release) stop.release();
    if (!options.quiet) out << closing_line(options, result, wall_s) << std::endl;
    if (result.outcome == drive::Outcome::Lost) error << "flownav-nav: " << result.why << '\n';
    recorder.complete();  // first: what was measured is kept whatever else cannot be written
    const int left_out = recorder.fields_left_out();
    if (left_out > 0) {
        error << "flownav-nav: warning: " << left_out
              << " images are missing in the recording: the disk was too slow for them\n";
    }
    if (!options.result.empty()) io::write_file(options.result, result_json(options, result, left_out));
    if (!options.picture.empty())
        write_picture(options.picture,
                      report::drive_picture(drive_scene(options.drive, result), onlooker.map()));
    report(options);
    return status_of(result.outcome);
}

}  // namespace

int run_nav_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    return run_nav_app(arguments, {}, out, error);
}

int run_nav_app(const std::vector<std::string>& arguments, const StopRequest& stop, std::ostream& out,
                std::ostream& error) {
    const auto fail = [&error](const std::exception& exception, cli::ExitStatus status) {
        error << "flownav-nav: " << exception.what() << '\n';
        return cli::exit_code(status);
    };
    try {
        int status = 0;
        const auto options = parse_nav_options(arguments, out, error, status);
        return options ? run_drive(*options, stop, out, error) : status;
    } catch (const config::ConfigError& exception) {
        return fail(exception, cli::ExitStatus::Usage);
    } catch (const io::OutputError& exception) {
        return fail(exception, cli::ExitStatus::Output);
    } catch (const std::invalid_argument& exception) {  // the address of a robot
        return fail(exception, cli::ExitStatus::Usage);
    } catch (const std::exception& exception) {
        return fail(exception, cli::ExitStatus::Input);
    }
}

}  // namespace flownav
