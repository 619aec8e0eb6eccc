#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "flownav/io/image_sequence.h"

namespace flownav::io {

/// Rectified images whose file names are numbers: number i has time i and pose i.
class KittiImages : public ImageSequence {
  public:
    std::optional<SequenceFrame> next() override;
    std::size_t size() const override { return images_.size(); }

  protected:
    std::vector<std::filesystem::path> images_;
    std::vector<double> times_s_;
    std::vector<Pose2> T_start_robot_;  ///< may have fewer poses than images, or none
    CameraModel camera_;                ///< without image size

  private:
    std::size_t at_ = 0;
};

/// A sequence of the KITTI odometry benchmark: DIR/sequences/SEQ/{image_0/*.png, calib.txt, times.txt} and,
/// optionally, DIR/poses/SEQ.txt. The poses of camera 0 in the frame of its first image are converted to
/// poses of the axis the car turns about, on the ground, with `mount`.
class KittiOdometry : public KittiImages {
  public:
    KittiOdometry(const std::filesystem::path& directory, const std::string& sequence,
                  const CameraMount& mount);
};

/// A rectified drive of the KITTI raw data: DATEDIR/calib_cam_to_cam.txt and
/// DATEDIR/DRIVE/image_0N/data/*.png, where DRIVE is the folder's name or the part of it between "drive_" and
/// "_sync". Uses the camera with the lowest number, grey camera 0 if present. Times come from
/// image_0N/timestamps.txt, or else from `rate_hz`. Poses come from oxts/data if present; its GPS/IMU unit is
/// taken to sit at the axis.
class KittiRaw : public KittiImages {
  public:
    /// `mount`: mount of camera 0; the sideways offset of another camera is added from the calibration.
    KittiRaw(const std::filesystem::path& date_directory, const std::string& drive, double rate_hz,
             const CameraMount& mount);
};

}  // namespace flownav::io
