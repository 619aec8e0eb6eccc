#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"

/// What the importers share: pictures and the small text files of data sets. All throw InputError, naming the
/// file, unless said otherwise.
namespace flownav::io {

void require_directory(const std::filesystem::path& directory);

/// The pictures of a folder, ordered by name with numbers as numbers. Throws when there are none.
std::vector<std::filesystem::path> list_images(const std::filesystem::path& directory);

/// A picture as an 8-bit grey field without time and camera, or nothing when it cannot be read.
std::optional<Field> load_grey(const std::filesystem::path& file);

std::vector<std::string> read_lines(const std::filesystem::path& file);

/// The numbers of one line, separated by commas, semicolons or blanks; empty when something else is in it.
std::vector<double> numbers_of(const std::string& line);

/// KITTI's calibration: "KEY: number number ..." a line; keys whose values are no numbers are left out.
std::map<std::string, std::vector<double>> read_kitti_calibration(const std::filesystem::path& file);

/// Pinhole camera of a 3x4 projection matrix. `file` and `key` are for the error.
CameraModel kitti_camera(const std::map<std::string, std::vector<double>>& calibration,
                         const std::string& key, const std::filesystem::path& file, const CameraMount& mount);

}  // namespace flownav::io
