#pragma once
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/camera_model.h"
#include "flownav/io/time_unit.h"

namespace flownav {

enum class ImportKind { KittiOdometry, KittiRaw, Tum, Euroc, Images, Video };

/// Parsed command line of flownav-import.
struct ImportOptions {
    ImportKind kind = ImportKind::Images;
    std::filesystem::path source;  ///< DIR, DATEDIR or FILE
    std::string part;              ///< SEQ or DRIVE
    std::filesystem::path output;
    CameraMount mount;            ///< mount of KITTI's camera 0
    config::CameraConfig camera;  ///< camera of pictures and videos
    std::optional<double> rate_hz;
    std::filesystem::path times;
    std::optional<io::TimeUnit> times_unit;
    bool quiet = false;
};

/// Parses the arguments; empty when they have been answered, with the exit status in `status`. Throws
/// ConfigError for an invalid camera file or value.
std::optional<ImportOptions> parse_import_options(const std::vector<std::string>& arguments,
                                                  std::ostream& out, std::ostream& error, int& status);

}  // namespace flownav
