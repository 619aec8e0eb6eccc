#include "nav_app.h"

#include <chrono>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <thread>

#include "camera_thread.h"
#include "drive_files.h"
#include "drive_picture.h"
#include "flownav/nav/tcp_robot.h"
#include "flownav/replay/drive_recording.h"
#include "flownav/replay/number_text.h"
#include "flownav/replay/replay.h"
#include "nav_options.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;

enum Status { fine = 0, usage = 1, input = 2, output = 3 };

int status_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::Reached:
            return 0;
        case Outcome::Blocked:
            return 4;
        case Outcome::Collision:
            return 5;
        case Outcome::Timeout:
            return 6;
    }
    return 6;
}

constexpr double progress_every_s = 10.0;

/// Keeps what was asked for, while the robot drives, and tells how far it is.
class Keeper : public DriveObserver {
  public:
    Keeper(const NavOptions& options, std::ostream& out)
        : options_(options), out_(out), began_(std::chrono::steady_clock::now()) {
        if (!options.record.empty()) recorder_.emplace(options.record);
        if (!options.output.empty()) {
            csv_.emplace(options.output / "drive.csv");
            csv_->write(drive_csv_header());
        }
    }

    void on_field(const Field& field, const pipeline::Step&) override {
        if (recorder_) recorder_->write(field);
    }
    void on_odometry(double timestamp_s, const Pose2& pose) override {
        if (recorder_) recorder_->write_odometry(timestamp_s, pose);
    }
    void on_truth(double timestamp_s, const Pose2& pose) override {
        if (recorder_) recorder_->write_truth(timestamp_s, pose);
    }
    void on_decision(const DriveSample& sample, const nav::Autopilot& autopilot) override {
        if (csv_) csv_->write(drive_csv_row(sample, autopilot));
        map_ = autopilot.map();
        if (!options_.quiet && sample.time_s >= next_progress_s_) {
            const nav::PilotDecision& decision = autopilot.decision();
            out_ << fixed_text(sample.time_s, 0) << " s: at " << fixed_text(sample.T_map_robot.x_m, 1) << ' '
                 << fixed_text(sample.T_map_robot.y_m, 1) << " m, " << to_string(decision.state)
                 << (decision.why.empty() ? "" : ", " + decision.why) << std::endl;
            next_progress_s_ += progress_every_s;
        }
    }
    void on_tick(const DriveSample& sample) override {
        if (options_.realtime)
            std::this_thread::sleep_until(began_ + std::chrono::duration<double>(sample.time_s));
    }

    void close() {
        if (recorder_) recorder_->complete();
        if (csv_) csv_->close();
    }
    const mrpt::maps::COccupancyGridMap2D& map() const { return map_; }

  private:
    const NavOptions& options_;
    std::ostream& out_;
    double next_progress_s_ = progress_every_s;
    std::chrono::steady_clock::time_point began_;
    std::optional<DriveRecording> recorder_;
    std::optional<OutputFile> csv_;
    mrpt::maps::COccupancyGridMap2D map_;
};

void write_picture(const fs::path& file, const cv::Mat& picture) {
    std::vector<std::uint8_t> png;
    cv::imencode(".png", picture, png);
    write_file(file, {reinterpret_cast<const char*>(png.data()), png.size()});
}

/// Where --output puts what has no place of its own.
void complete(NavOptions& options) {
    if (options.output.empty()) return;
    make_output_folder(options.output);
    if (options.result.empty()) options.result = options.output / "result.json";
    if (options.picture.empty()) options.picture = options.output / "drive.png";
    if (options.record.empty() && options.drive.sensor == SensorKind::Flow)
        options.record = options.output / "run.rawlog";
}

/// The sensor's own account of the drive, from the recording.
void report(const NavOptions& options) {
    if (options.output.empty() || options.record.empty()) return;
    ReplayOptions replaying;
    replaying.input = options.record;
    replaying.output = options.output;
    replaying.config = options.drive.config;
    const ReplayResult result = replay(replaying);
    if (result.status == ExitStatus::Output) throw OutputError(result.message);
}

std::string closing_line(const DriveResult& result, double wall_s) {
    std::string line = to_string(result.outcome);
    if (!result.why.empty()) line += " (" + result.why + ')';
    return line + ": " + fixed_text(result.path_m, 2) + " m in " + fixed_text(result.time_s, 1) +
           " s, nearest " + fixed_text(result.min_clearance_m, 2) + " m, " +
           fixed_text(result.time_s / wall_s, 1) + " times real time";
}

int drive(NavOptions options, std::ostream& out) {
    complete(options);
    Keeper keeper(options, out);
    const auto began = std::chrono::steady_clock::now();
    const DriveResult result = simulate_drive(options.drive, keeper);
    const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    keeper.close();
    if (!options.result.empty()) write_file(options.result, result_json(options, result));
    if (!options.picture.empty())
        write_picture(options.picture, drive_picture(options.drive, result, keeper.map()));
    report(options);
    if (!options.quiet) out << closing_line(result, wall_s) << '\n';
    return status_of(result.outcome);
}

double system_time_s() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// A real robot. Its camera is opened before its motors.
int drive_real(const NavOptions& options, std::ostream& out) {
    const nav::TcpAddress address = nav::parse_tcp_address(options.robot);
    ProducerSettings settings = read_producer_settings(options.camera.string());
    settings.config.map = options.drive.config.map;
    CameraThread camera(settings);
    nav::TcpRobot robot(address);
    RobotDriveOptions driving;
    driving.config = options.drive.config;
    driving.start = options.drive.start;
    driving.goals_m = options.drive.goals_m;
    driving.waypoint_robot_m = options.drive.waypoint_robot_m;
    driving.timeout_s = options.drive.timeout_s;
    driving.navlog_directory = options.drive.navlog_directory;
    driving.clock_s = system_time_s;
    driving.wait_until_s = [](double time_s) {
        std::this_thread::sleep_for(std::chrono::duration<double>(time_s - system_time_s()));
    };
    const RobotDriveResult driven = drive_robot(driving, robot, camera);
    DriveResult result;
    result.outcome = driven.outcome;
    result.why = driven.why;
    result.time_s = driven.time_s;
    result.path_m = driven.path_m;
    result.stops = driven.stops;
    if (!options.result.empty()) write_file(options.result, result_json(options, result));
    if (!options.quiet) {
        out << to_string(result.outcome) << (result.why.empty() ? "" : " (" + result.why + ')') << ": "
            << fixed_text(result.path_m, 2) << " m in " << fixed_text(result.time_s, 1) << " s\n";
    }
    return status_of(result.outcome);
}

}  // namespace

int run_nav_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    try {
        int status = fine;
        const auto options = parse_nav_options(arguments, out, error, status);
        if (!options) return status;
        return options->robot == "sim" ? drive(*options, out) : drive_real(*options, out);
    } catch (const ConfigError& exception) {
        error << "flownav-nav: " << exception.what() << '\n';
        return usage;
    } catch (const OutputError& exception) {
        error << "flownav-nav: " << exception.what() << '\n';
        return output;
    } catch (const std::invalid_argument& exception) {  // the address of a robot
        error << "flownav-nav: " << exception.what() << '\n';
        return usage;
    } catch (const std::exception& exception) {
        error << "flownav-nav: " << exception.what() << '\n';
        return input;
    }
}

}  // namespace flownav
