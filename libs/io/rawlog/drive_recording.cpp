#include "flownav/io/drive_recording.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>
#include <system_error>

#include "flownav/io/observations.h"
#include "flownav/io/output_file.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;

/// File that gets its name in complete() and is otherwise removed by the destructor. A target that is not a
/// regular file, such as a device, is written in place.
class PendingFile {
  public:
    explicit PendingFile(const fs::path& target) : target_(target), path_(target) {
        std::error_code error;
        const auto status = fs::status(target, error);
        if (fs::is_directory(status)) throw OutputError("cannot write " + target.string() + ": is a folder");
        if (!fs::exists(status) || fs::is_regular_file(status)) path_ += ".part";
    }
    ~PendingFile() {
        std::error_code error;
        if (!done_ && path_ != target_) fs::remove(path_, error);
    }
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const fs::path& path() const { return path_; }

    void complete() {
        std::error_code error;
        if (path_ != target_) fs::rename(path_, target_, error);
        if (error) throw OutputError("cannot write " + target_.string() + ": " + error.message());
        done_ = true;
    }

  private:
    fs::path target_;
    fs::path path_;
    bool done_ = false;
};

}  // namespace

struct DriveRecording::Parts {
    Parts(const fs::path& target, std::string camera_label)
        : pending(target), file(pending.path()), label(std::move(camera_label)) {}

    PendingFile pending;
    GzOutputFile file;
    std::string label;
};

DriveRecording::DriveRecording(const fs::path& target, std::string camera_label)
    : parts_(std::make_unique<Parts>(target, std::move(camera_label))) {}

DriveRecording::~DriveRecording() = default;

void DriveRecording::write(const Field& field) {
    write_object(parts_->file, *image_observation(field, parts_->label));
}

void DriveRecording::write_odometry(double timestamp_s, const Pose2& T_odom_robot) {
    mrpt::obs::CObservationOdometry odometry;
    odometry.timestamp = mrpt::Clock::fromDouble(timestamp_s);
    odometry.sensorLabel = "ODOMETRY";
    odometry.odometry = mrpt::poses::CPose2D(T_odom_robot.x_m, T_odom_robot.y_m, T_odom_robot.yaw_rad);
    write_object(parts_->file, odometry);
}

void DriveRecording::write_gyro(const GyroRate& reading) {
    mrpt::obs::CObservationIMU imu;
    imu.timestamp = mrpt::Clock::fromDouble(reading.timestamp_s);
    imu.sensorLabel = "IMU";
    imu.set(mrpt::obs::IMU_WZ, reading.omega_radps);
    write_object(parts_->file, imu);
}

void DriveRecording::write_truth(double timestamp_s, const Pose2& T_world_robot,
                                 const Eigen::Isometry3d& T_flat_robot) {
    mrpt::obs::CObservationRobotPose truth;
    truth.timestamp = mrpt::Clock::fromDouble(timestamp_s);
    truth.sensorLabel = "GROUND_TRUTH";
    const Eigen::Matrix3d R = T_flat_robot.linear();
    const double pitch_rad = std::atan2(0.0 - R(2, 0), std::hypot(R(2, 1), R(2, 2)));  // never -0
    const double roll_rad = std::atan2(R(2, 1), R(2, 2));
    truth.pose.mean =
        mrpt::poses::CPose3D(T_world_robot.x_m, T_world_robot.y_m, T_flat_robot.translation().z(),
                             T_world_robot.yaw_rad, pitch_rad, roll_rad);
    write_object(parts_->file, truth);
}

void DriveRecording::complete() {
    parts_->file.close();
    parts_->pending.complete();
}

}  // namespace flownav::io
