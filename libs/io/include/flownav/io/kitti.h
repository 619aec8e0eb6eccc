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
    std::vector<Pose2> T_start_robot_;  ///< may be shorter, or empty
    CameraModel camera_;                ///< without image size

  private:
    std::size_t at_ = 0;
};

/// A sequence of the KITTI odometry benchmark: DIR/sequences/SEQ/{image_0/*.png, calib.txt, times.txt} and,
/// when there, DIR/poses/SEQ.txt. Its poses are those of camera 0 in its first image's frame; they become
/// poses of the axis the car turns about, on the ground, with the mount given.
class KittiOdometry : public KittiImages {
  public:
    KittiOdometry(const std::filesystem::path& directory, const std::string& sequence,
                  const CameraMount& mount);
};

/// A rectified drive of the KITTI raw data: DATEDIR/calib_cam_to_cam.txt and
/// DATEDIR/DRIVE/image_0N/data/*.png, where DRIVE is the folder's name or the part of it between "drive_" and
/// "_sync". The grey camera 0 is taken when it is there, else the lowest number. Times come from
/// image_0N/timestamps.txt, or else from `rate_hz`; poses from oxts/data when it is there (its unit sits at
/// the rear axle).
class KittiRaw : public KittiImages {
  public:
    /// `mount` is that of camera 0; the sideways offset of another camera is added from the calibration.
    KittiRaw(const std::filesystem::path& date_directory, const std::string& drive, double rate_hz,
             const CameraMount& mount);
};

}  // namespace flownav::io
