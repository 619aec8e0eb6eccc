#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"

/// Shared by the importers: pictures and the small text files of data sets. The functions throw InputError
/// naming the file unless documented otherwise.
namespace flownav::io {

void require_directory(const std::filesystem::path& directory);

/// Pictures of a folder, ordered by name with digits compared as numbers. Throws when there are none.
std::vector<std::filesystem::path> list_images(const std::filesystem::path& directory);

/// Loads a picture as an 8-bit grey field without time and camera; empty when it cannot be read.
std::optional<Field> load_grey(const std::filesystem::path& file);

std::vector<std::string> read_lines(const std::filesystem::path& file);

/// Numbers of one line, separated by commas, semicolons or blanks; empty when the line holds other text. Does
/// not throw.
std::vector<double> numbers_of(const std::string& line);

/// Reads KITTI's calibration: one "KEY: number number ..." per line. Keys with other values are left out.
std::map<std::string, std::vector<double>> read_kitti_calibration(const std::filesystem::path& file);

/// Pinhole camera of the 3x4 projection matrix `key`; its baseline is added to mount.left_m. `file` is for
/// the error message.
CameraModel kitti_camera(const std::map<std::string, std::vector<double>>& calibration,
                         const std::string& key, const std::filesystem::path& file, const CameraMount& mount);

}  // namespace flownav::io
