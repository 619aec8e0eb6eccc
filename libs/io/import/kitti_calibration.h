#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "flownav/core/camera_model.h"

namespace flownav::io {

/// KITTI's calibration: numbers by key. Keys with other values are left out.
struct KittiCalibration {
    std::filesystem::path file;
    std::map<std::string, std::vector<double>> numbers;

    /// Numbers of a key; empty when there are none, or not `count`.
    std::vector<double> of(const std::string& key, std::size_t count) const;
};

/// Reads a file with one "KEY: number number ..." per line. Throws InputError.
KittiCalibration read_kitti_calibration(const std::filesystem::path& file);

/// Pinhole camera of the 3x4 projection matrix `key`, without image size; its baseline is added to
/// mount.left_m. Throws InputError when the file lacks the key.
CameraModel kitti_camera(const KittiCalibration& calibration, const std::string& key,
                         const CameraMount& mount);

/// A camera and what was found out about it, one sentence; empty: nothing to tell.
struct FoundCamera {
    CameraModel camera;
    std::string note;
};

/// Camera "00" .. "03" of the raw data for images of width_px x height_px: rectified (P_rect) when they have
/// the size S_rect, or that shape and another size; as it was taken (K and D) when they have the size S.
/// Throws InputError for other sizes and for missing keys.
FoundCamera kitti_raw_camera(const KittiCalibration& calibration, const std::string& number, int width_px,
                             int height_px, const CameraMount& mount);

}  // namespace flownav::io
