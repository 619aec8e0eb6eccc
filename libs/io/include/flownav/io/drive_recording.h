#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <string>

#include "flownav/core/field.h"
#include "flownav/core/pose2.h"
#include "flownav/core/readings.h"

namespace flownav::io {

/// Writes a drive as a gz rawlog of standard observations. The file gets its name in complete(); without it
/// the destructor removes the file. All functions throw OutputError.
class DriveRecording {
  public:
    explicit DriveRecording(const std::filesystem::path& target, std::string camera_label = "CAMERA1");
    ~DriveRecording();
    DriveRecording(const DriveRecording&) = delete;
    DriveRecording& operator=(const DriveRecording&) = delete;

    /// Writes a CObservationImage with calibration and camera pose.
    void write(const Field& field);
    /// Writes a CObservationOdometry labelled ODOMETRY.
    void write_odometry(double timestamp_s, const Pose2& T_odom_robot);
    /// Writes a CObservationIMU labelled IMU.
    void write_gyro(const GyroRate& reading);
    /// Writes a CObservationRobotPose labelled GROUND_TRUTH. `T_flat_robot`: height and tilt of the robot, in
    /// the frame that T_world_robot has on the plane z = 0.
    void write_truth(double timestamp_s, const Pose2& T_world_robot,
                     const Eigen::Isometry3d& T_flat_robot = Eigen::Isometry3d::Identity());

    void complete();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace flownav::io
