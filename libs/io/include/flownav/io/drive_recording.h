#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "flownav/core/field.h"
#include "flownav/core/pose2.h"

namespace flownav::io {

/// A drive that is written as a gz rawlog of standard observations. The file appears under its name only when
/// it is complete; a recording that is not completed leaves nothing behind. Everything throws OutputError.
class DriveRecording {
  public:
    explicit DriveRecording(const std::filesystem::path& target, std::string camera_label = "CAMERA1");
    ~DriveRecording();
    DriveRecording(const DriveRecording&) = delete;
    DriveRecording& operator=(const DriveRecording&) = delete;

    /// CObservationImage with calibration and camera pose.
    void write(const Field& field);
    /// CObservationOdometry ODOMETRY.
    void write_odometry(double timestamp_s, const Pose2& T_odom_robot);
    /// CObservationRobotPose GROUND_TRUTH.
    void write_truth(double timestamp_s, const Pose2& T_world_robot);

    void complete();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace flownav::io
