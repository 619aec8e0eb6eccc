#pragma once
#include <filesystem>
#include <memory>

#include "flownav/config/config.h"
#include "flownav/io/image_folder.h"

namespace flownav::io {

enum class DataSetKind { None, Tum, Euroc };

/// Kind of the data set in a folder: TUM (rgb.txt and what it lists) or EuRoC (mav0/cam0/data.csv; the folder
/// itself, mav0 or cam0).
DataSetKind data_set_kind(const std::filesystem::path& directory);

class PoseTrack;

/// Images of a TUM or EuRoC folder with the times of its list. Ground truth (groundtruth.txt,
/// state_groundtruth_estimate0) becomes the pose of the robot's axis on the ground in the frame of the first.
/// EuRoC's sensor.yaml gives the intrinsics and distortion that the configuration leaves open.
class DataSetFolder : public ImageSequence {
  public:
    /// Throws InputError: the folder holds no such data set, or its parts contradict each other.
    DataSetFolder(const std::filesystem::path& directory, DataSetKind kind, config::CameraConfig camera,
                  std::optional<TimeUnit> unit);
    ~DataSetFolder() override;

    std::optional<SequenceFrame> next() override;
    std::size_t size() const override;

    /// Description of the source of the times, for messages.
    const std::string& times_source() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace flownav::io
