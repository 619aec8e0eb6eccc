#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "flownav/core/lens.h"
#include "flownav/core/navigation_params.h"
#include "flownav/mapping/params.h"
#include "flownav/nav/guard_params.h"
#include "flownav/nav/recovery_params.h"
#include "flownav/pipeline/params.h"

namespace flownav::config {

enum class Interlaced { None, TopFirst, BottomFirst };

/// Rows of an image, both ends included.
struct RowRange {
    int first = 0, last = 0;
};

/// The section [camera]. An empty optional ("recorded" in the ini) leaves the value of the recording.
struct CameraConfig {
    std::string camera_label = "CAMERA1";
    Interlaced interlaced = Interlaced::None;
    std::optional<double> height_m, pitch_deg, roll_deg, yaw_deg, forward_m, left_m;
    std::optional<double> fx_px, fy_px, cx_px, cy_px;  ///< of the image as recorded (a whole frame if woven)
    std::optional<LensCoefficients> distortion;        ///< of `lens`
    std::string lens = brown_conrady().name();         ///< name of a registered lens
    int rotate_deg = 0;   ///< clockwise turn of each image as it is read: 0, 90, 180 or 270
    bool mirror = false;  ///< exchange left and right of each image as it is read, before it is turned
    std::optional<RowRange> masked_rows;  ///< of the turned image: show the robot itself, and are cut off
};

/// The section [input]: labels and clock of the recording's poses.
struct InputConfig {
    std::string odometry_label = "ODOMETRY";
    std::string truth_label = "GROUND_TRUTH";
    double odometry_offset_s = 0.0;  ///< added to the times of the odometry
};

/// All settings of the ini.
struct Config {
    CameraConfig camera;
    InputConfig input;
    pipeline::Params pipeline;
    mapping::MapParams map;
    NavigationParams navigation;
    nav::RecoveryParams recovery;  ///< section [navigation]
    nav::GuardParams guard;
};

/// A value, key or file that cannot be used; what() names it, the reason, and the allowed values.
struct ConfigError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The documentation of one key.
struct ConfigKey {
    std::string section, name, default_value, unit, range, help;
    bool everyday = false;                   ///< false: an advanced key
    std::vector<std::string> earlier_names;  ///< "section.key"; still read, with a warning

    std::string full_name() const { return section + "." + name; }
};

enum class KeySet { All, Everyday };

/// All keys, the keys of a section side by side.
std::vector<ConfigKey> config_keys();

/// A key ("section.key") and its text.
struct Setting {
    std::string key, value;
};

/// The same setting with the present names instead of earlier ones of key and value. Unknown keys stay as
/// they are.
Setting present_setting(Setting setting);

/// Sets one key ("section.key") from its text. An earlier name is read as well, with one warning a process on
/// stderr. Throws ConfigError: unknown key (names the nearest known one), unparsable, not finite, or out of
/// range (names key, value and range).
void set_config_value(Config& config, const std::string& key, const std::string& value);

/// The text of one key ("section.key"). Throws ConfigError: unknown key.
std::string config_value(const Config& config, const std::string& key);

/// Reads an ini (MRPT conventions: sections, comments with // ; #, @define) on top of `config`.
/// Throws ConfigError naming file, key, value and range.
void load_config_file(Config& config, const std::string& path);

/// Throws ConfigError, which names the keys, when limits of the contact scan are in the wrong order.
void check_contacts(const Config& config);

/// Throws ConfigError, which names the keys, when the local map would have more than 2000 cells across.
void check_map(const Config& config);

/// Throws ConfigError, which names the keys, when the robot has no room in the local map, or the pauses of
/// the guard contradict each other.
void check_navigation(const Config& config);

/// The ini text of a configuration, each key with its documentation: the everyday keys by section, then,
/// under a heading, the advanced keys by section.
std::string dump_config(const Config& config, KeySet keys = KeySet::All);

/// The ini text of the keys whose values are not the defaults; empty when all values are defaults.
std::string dump_changes(const Config& config);

/// The keys as one table in markdown, the everyday keys first.
std::string document_config(KeySet keys = KeySet::All);

}  // namespace flownav::config
