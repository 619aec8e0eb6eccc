#include "flownav/drive/drive_recorder.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "background_writer.h"
#include "flownav/cli/number_text.h"
#include "flownav/io/drive_recording.h"
#include "flownav/io/output_file.h"

namespace flownav::drive {
namespace {

constexpr std::size_t waiting_max = 100;  // limit of waiting jobs, a few seconds of images

std::string columns(const Pose2& pose) {
    return cli::fixed_text(pose.x_m, 4) + ',' + cli::fixed_text(pose.y_m, 4) + ',' +
           cli::fixed_text(pose.yaw_rad, 5);
}

/// Pitch > 0 looks down, as of a camera.
std::string true_columns(const DriveSample& sample) {
    const Eigen::Vector3d forward = sample.T_flat_robot.linear().col(0);
    return columns(sample.T_world_robot) + ',' + cli::fixed_text(sample.T_flat_robot.translation().z(), 4) +
           ',' + cli::fixed_text(std::asin(0.0 - forward.z()), 5);
}

std::string columns(const MotionCommand& motion) {
    return cli::fixed_text(motion.v_mps, 3) + ',' + cli::fixed_text(motion.omega_radps, 3);
}

}  // namespace

struct DriveRecorder::Impl {
    explicit Impl(const DriveRecorderOptions& its_options) : options(its_options) {
        if (!options.rawlog.empty()) rawlog.emplace(options.rawlog);
        if (!options.csv.empty()) {
            csv.emplace(options.csv);
            csv->write(drive_csv_header());
        }
    }

    DriveRecorderOptions options;
    std::optional<io::DriveRecording> rawlog;
    std::optional<io::OutputFile> csv;
    std::atomic<int> fields_left_out{0};
    BackgroundWriter writer;  ///< last: ends before the files are closed
};

DriveRecorder::DriveRecorder(const DriveRecorderOptions& options) : impl_(std::make_unique<Impl>(options)) {}
DriveRecorder::~DriveRecorder() = default;

void DriveRecorder::on_field(const Field& field, const pipeline::Step& /*step*/) {
    if (!impl_->rawlog) return;
    const auto job = [this, field] { impl_->rawlog->write(field); };
    if (impl_->options.may_wait) {
        impl_->writer.push_when_fewer(job, waiting_max);
    } else if (!impl_->writer.push_if_fewer(job, waiting_max)) {
        ++impl_->fields_left_out;
    }
}

void DriveRecorder::on_odometry(double timestamp_s, const Pose2& T_odom_robot) {
    if (!impl_->rawlog) return;
    impl_->writer.push([=] { impl_->rawlog->write_odometry(timestamp_s, T_odom_robot); });
}

void DriveRecorder::on_truth(double timestamp_s, const Pose2& T_world_robot,
                             const Eigen::Isometry3d& T_flat_robot) {
    if (!impl_->rawlog) return;
    impl_->writer.push([=] { impl_->rawlog->write_truth(timestamp_s, T_world_robot, T_flat_robot); });
}

void DriveRecorder::on_decision(const DriveSample& sample, const nav::NavigationStack& stack) {
    if (!impl_->csv) return;
    std::string row = drive_csv_row(sample, stack.decision(), stack.safety().action);
    impl_->writer.push([this, row = std::move(row)] { impl_->csv->write(row); });
}

void DriveRecorder::complete() {
    impl_->writer.finish();
    if (impl_->rawlog) impl_->rawlog->complete();
    if (impl_->csv) impl_->csv->close();
}

int DriveRecorder::fields_left_out() const {
    return impl_->fields_left_out;
}

std::string drive_csv_header() {
    return "time_s,true_x_m,true_y_m,true_yaw_rad,true_z_m,true_pitch_rad,map_x_m,map_y_m,map_yaw_rad,"
           "odom_x_m,odom_y_m,odom_yaw_rad,v_mps,omega_radps,proposed_v_mps,proposed_omega_radps,command_v_"
           "mps,"
           "command_omega_radps,waypoint_x_m,waypoint_y_m,clearance_m,state,action,why\n";
}

std::string drive_csv_row(const DriveSample& sample, const nav::RecoveryDecision& decision,
                          nav::GuardAction action) {
    std::string why = decision.why;
    std::replace(why.begin(), why.end(), ',', ';');
    const std::string truth = sample.truth_known ? true_columns(sample) : ",,,,";
    const std::string clearance = sample.truth_known ? cli::fixed_text(sample.clearance_m, 3) : "";
    return cli::fixed_text(sample.time_s, 2) + ',' + truth + ',' + columns(sample.T_map_robot) + ',' +
           columns(sample.odometry) + ',' + columns(sample.motion) + ',' + columns(sample.proposed) + ',' +
           columns(sample.command) + ',' + cli::fixed_text(decision.waypoint_m.x(), 3) + ',' +
           cli::fixed_text(decision.waypoint_m.y(), 3) + ',' + clearance + ',' + to_string(decision.state) +
           ',' + to_string(action) + ',' + why + '\n';
}

}  // namespace flownav::drive
