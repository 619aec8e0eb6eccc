#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "flownav/io/image_sequence.h"

namespace flownav::io {

class GreyPictures;

/// Images whose file names are numbers: number i has time i and pose i.
class KittiImages : public ImageSequence {
  public:
    ~KittiImages() override;

    std::optional<SequenceFrame> next() override;
    std::size_t size() const override { return images_.size(); }

  protected:
    KittiImages();

    /// Takes the images of a folder. Throws InputError: no images, or a name that is no number.
    void take_images(const std::filesystem::path& folder);

    /// Largest number of an image, plus 1.
    std::size_t numbers() const;

    /// Tells of times without an image, and of images in a row of numbers that are missing.
    void tell_missing_images();

    std::vector<std::filesystem::path> images_;
    std::vector<std::optional<double>> times_s_;  ///< by number; empty: lost
    std::vector<std::optional<Pose2>>
        T_start_robot_;   ///< by number; may be shorter than the images, or empty
    CameraModel camera_;  ///< without image size

  private:
    std::unique_ptr<GreyPictures> pictures_;
    std::optional<double> last_s_;
    std::size_t at_ = 0;
};

/// A sequence of the KITTI odometry benchmark: DIR/sequences/SEQ/{image_0/*.png, calib.txt, times.txt} and,
/// optionally, DIR/poses/SEQ.txt. The lowest of image_0 .. image_3 that has images is taken. The poses of
/// camera 0 in the frame of its first image are converted to poses of the axis the car turns about, on the
/// ground, with `mount`.
class KittiOdometry : public KittiImages {
  public:
    KittiOdometry(const std::filesystem::path& directory, const std::string& sequence,
                  const CameraMount& mount);
};

/// A drive of the KITTI raw data: DATEDIR/calib_cam_to_cam.txt and DATEDIR/DRIVE/image_0N/data/*.png, where
/// DRIVE is the folder's name or the part of it between "drive_" and "_sync" or "_extract". Uses the camera
/// with the lowest number that has images, grey camera 0 if present; rectified by P_rect, or, where the
/// images have the size S, as they were taken, with K and D. Times come from image_0N/timestamps.txt, where
/// line i + 1 is the time of number i and an empty line a lost image; or else from `rate_hz` and the numbers.
/// Poses come from oxts/data if present, by number; its GPS/IMU unit is taken to sit at the axis.
class KittiRaw : public KittiImages {
  public:
    /// `mount`: mount of camera 0; the sideways offset of another camera is added from the calibration.
    KittiRaw(const std::filesystem::path& date_directory, const std::string& drive, double rate_hz,
             const CameraMount& mount);
};

/// Mount of KITTI's camera 0 on the day of a raw drive ("2011_09_26"), or in a sequence of the odometry
/// benchmark ("00"), as far as it has been measured: 1.65 m over the ground, 1.1 m ahead of the rear axle,
/// and the angles fitted to the poses of sequence 00 for the sequences of its day.
CameraMount kitti_mount(const std::string& day_or_sequence);

}  // namespace flownav::io
