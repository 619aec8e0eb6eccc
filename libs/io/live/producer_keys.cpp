#include "producer_keys.h"

#include <mrpt/system/string_utils.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "flownav/config/config_value.h"
#include "flownav/config/nearest_name.h"

namespace flownav::io {
namespace {

using mrpt::system::lowerCase;
using Names = std::vector<std::string>;

bool parse_bool(const std::string& text) {
    const std::string word = lowerCase(text);
    if (word == "true" || word == "yes" || word == "1") return true;
    if (word == "false" || word == "no" || word == "0") return false;
    throw config::BadValue("is neither true nor false");
}

std::string parse_label(const std::string& text) {
    if (text.empty()) throw config::BadValue("is empty");
    return text;
}

/// A key of the producer itself: name, allowed values and setter.
struct OwnKey {
    std::string name;
    std::string allowed;
    std::function<void(ProducerSettings&, const std::string&)> set;
};

template <class Value>
OwnKey number(const char* name, const char* unit, Value ProducerSettings::*member,
              config::Range<double> range) {
    return {name, config::describe(range) + unit,
            [member, range](ProducerSettings& settings, const std::string& text) {
                settings.*member = config::parse_number(text, range);
            }};
}

OwnKey flag(const char* name, bool ProducerSettings::*member) {
    return {name, "true or false", [member](ProducerSettings& settings, const std::string& text) {
                settings.*member = parse_bool(text);
            }};
}

const std::vector<OwnKey>& own_keys() {
    static const std::vector<OwnKey> keys = {
        {"label_prefix", "any text",
         [](ProducerSettings& settings, const std::string& text) {
             settings.label_prefix = parse_label(text);
         }},
        flag("use_odometry", &ProducerSettings::use_odometry),
        flag("publish_image", &ProducerSettings::publish_image),
        flag("paced", &ProducerSettings::paced),
        number("rate_hz", " images a second", &ProducerSettings::rate_hz, {0.01, 10000}),
        number("start_time_s", " seconds since 1970", &ProducerSettings::start_time_s, {0, 1e11}),
        number("end_wait_s", " seconds", &ProducerSettings::end_wait_s, {0, 3600}),
    };
    return keys;
}

/// Keys that read_producer_settings() reads before all others.
const Names& first_keys() {
    static const Names keys = {"grabber_type", "flownav_config"};
    return keys;
}

const Names& grabber_keys() {
    static const Names keys = {"driver",          "process_rate", "max_queue_len",
                               "grab_decimation", "sensorlabel",  "rawlog-grabber-ignore"};
    return keys;
}

const Names& camera_keys() {
    static const Names keys = {"preview_decimation",
                               "preview_reduction",
                               "capture_grayscale",
                               "cv_camera_index",
                               "cv_camera_type",
                               "cv_frame_width",
                               "cv_frame_height",
                               "cv_fps",
                               "cv_gain",
                               "ffmpeg_url",
                               "rawlog_camera_sensor_label",
                               "rawlog_file",
                               "image_dir_url",
                               "left_format",
                               "right_format",
                               "start_index",
                               "end_index",
                               "pose_x",
                               "pose_y",
                               "pose_z",
                               "pose_yaw",
                               "pose_pitch",
                               "pose_roll"};
    return keys;
}

/// Prefixes of the keys of cameras that have many.
const Names& camera_prefixes() {
    static const Names prefixes = {"dc1394_", "bumblebee_", "svs_",   "sr_",    "kinect_",
                                   "flycap_", "fcs_",       "myntd_", "duo3d_", "external_images_"};
    return prefixes;
}

bool contains(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

const OwnKey* own_key(const std::string& key) {
    const auto& keys = own_keys();
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const OwnKey& own) { return own.name == key; });
    return found == keys.end() ? nullptr : &*found;
}

Names all_keys() {
    Names names = first_keys();
    for (const OwnKey& key : own_keys()) names.push_back(key.name);
    for (const Names* more : {&grabber_keys(), &camera_keys()})
        names.insert(names.end(), more->begin(), more->end());
    return names;
}

}  // namespace

KeyOwner owner_of(const std::string& key) {
    const std::string name = lowerCase(key);
    const auto begins_name = [&](const std::string& prefix) { return name.rfind(prefix, 0) == 0; };
    if (name.find('.') != std::string::npos) return KeyOwner::Flownav;
    if (contains(first_keys(), name) || own_key(name) != nullptr) return KeyOwner::Producer;
    if (contains(grabber_keys(), name)) return KeyOwner::Grabber;
    const Names& prefixes = camera_prefixes();
    const bool camera =
        contains(camera_keys(), name) || std::any_of(prefixes.begin(), prefixes.end(), begins_name);
    return camera ? KeyOwner::Camera : KeyOwner::Nobody;
}

void set_producer_value(ProducerSettings& settings, const std::string& key, const std::string& value) {
    const OwnKey* const own = own_key(lowerCase(key));
    if (own == nullptr) return;  // the key is one of first_keys()
    try {
        own->set(settings, value);
    } catch (const config::BadValue& error) {
        throw config::ConfigError(own->name + " = " + value + " " + error.what() +
                                  " (allowed: " + own->allowed + ")");
    }
}

std::string nearest_producer_key(const std::string& key) {
    for (const config::ConfigKey& known : config::config_keys()) {
        Names names = known.earlier_names;
        names.push_back(known.full_name());
        for (const std::string& name : names) {
            if (name.substr(name.find('.') + 1) == lowerCase(key)) return known.full_name();
        }
    }
    return config::nearest_name(key, all_keys());
}

}  // namespace flownav::io
