#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <vector>

#include "flownav/core/camera_model.h"
#include "flownav/core/pose2.h"

namespace flownav::io {

/// A pose of the robot and its time.
struct TimedPose {
    double timestamp_s = 0.0;
    Pose2 T_world_robot;
};

/// Poses in the order of their times, interpolated between two that are at most 0.25 s apart.
class PoseTrack {
  public:
    PoseTrack() = default;
    explicit PoseTrack(std::vector<TimedPose> poses) : poses_(std::move(poses)) {}

    /// Empty before the first, after the last and in a gap.
    std::optional<Pose2> at(double timestamp_s) const;

    bool empty() const { return poses_.empty(); }

  private:
    std::vector<TimedPose> poses_;
};

/// A pose in space and its time, as data sets list them.
struct SpacePose {
    double timestamp_s = 0.0;
    Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
};

/// Reads TUM's groundtruth.txt: timestamp tx ty tz qx qy qz qw, in seconds and metres. Throws InputError.
std::vector<SpacePose> read_tum_poses(const std::filesystem::path& file);

/// Reads EuRoC's state_groundtruth_estimate0/data.csv: timestamp in ns, position, qw qx qy qz. Throws
/// InputError.
std::vector<SpacePose> read_euroc_poses(const std::filesystem::path& file);

/// Poses of the robot's axis on the ground (the world's z points up) of a body that carries the camera.
PoseTrack robot_track(const std::vector<SpacePose>& poses, const Eigen::Isometry3d& T_body_camera,
                      const CameraMount& mount);

}  // namespace flownav::io
