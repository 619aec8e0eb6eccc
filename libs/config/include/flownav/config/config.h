#pragma once
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "flownav/core/navigation_params.h"
#include "flownav/mapping/params.h"
#include "flownav/pipeline/params.h"

namespace flownav::config {

enum class Interlaced { None, TopFirst, BottomFirst };

/// What the ini says about the camera. An empty optional ("recorded" in the ini) means: as the recording has
/// it.
struct CameraConfig {
    std::string camera_label = "CAMERA1";
    Interlaced interlaced = Interlaced::None;
    std::optional<double> height_m, pitch_deg, roll_deg, yaw_deg, forward_m, left_m;
    std::optional<double> fx_px, fy_px, cx_px, cy_px;  ///< of the image as recorded (a whole frame if woven)
    std::optional<std::array<double, 5>> distortion;   ///< k1 k2 p1 p2 k3
};

/// Everything the ini can set.
struct Config {
    CameraConfig camera;
    pipeline::Params pipeline;
    mapping::MapParams map;
    NavigationParams navigation;
};

/// A value, key or file that cannot be used; what() says which, why, and what is allowed.
struct ConfigError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// One line of documentation of one key, for --doc and --dump.
struct ConfigKey {
    std::string section, name, default_value, unit, range, help;
};

/// Every key, in the order of the ini.
std::vector<ConfigKey> config_keys();

/// Sets one key ("section.key") from its text. Throws ConfigError: unknown key (names the nearest known one),
/// unparsable, not finite, or out of range (names key, value and range).
void set_config_value(Config& config, const std::string& key, const std::string& value);

/// Reads an ini (MRPT conventions: sections, comments with // ; #, @define) on top of `config`.
/// Throws ConfigError naming file, key, value and range.
void load_config_file(Config& config, const std::string& path);

/// Throws ConfigError, which names the keys, when the local map would have more cells than can be worked on.
void check_map(const Config& config);

/// Throws ConfigError, which names the keys, when the robot has no room in the local map.
void check_navigation(const Config& config);

/// The ini text of a configuration, each key with its documentation.
std::string dump_config(const Config& config);

/// The ini text of the keys whose values are not the defaults; empty when all are.
std::string dump_changes(const Config& config);

/// Every key as one table in markdown.
std::string document_config();

}  // namespace flownav::config
