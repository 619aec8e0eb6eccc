#include "flownav/io/producer_settings.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/vector_loadsave.h>
#include <mrpt/system/string_utils.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "producer_keys.h"

namespace flownav::io {
namespace {

using mrpt::config::CConfigFileBase;
using mrpt::system::lowerCase;
using mrpt::system::trim;

/// Text of a key; empty when it is missing.
std::string text_of(const CConfigFileBase& ini, const std::string& section, const std::string& key) {
    return trim(ini.read_string(section, key, ""));
}

/// Keys of a section, without lines commented out by //, which MRPT takes for keys.
std::vector<std::string> keys_of(const CConfigFileBase& ini, const std::string& section) {
    std::vector<std::string> keys;
    ini.getAllKeys(section, keys);
    const auto comment = [](const std::string& key) { return key.rfind("//", 0) == 0; };
    keys.erase(std::remove_if(keys.begin(), keys.end(), comment), keys.end());
    return keys;
}

/// Throws ConfigError for a decimation above 1, because MRPT would drop whole cycles.
void refuse_decimation(const std::string& key, const std::string& value) {
    if (lowerCase(key) != "grab_decimation" || value == "0" || value == "1") return;
    throw config::ConfigError("grab_decimation = " + value +
                              ": every field is needed; thin out the recording instead (allowed: 0 or 1)");
}

void set_key(ProducerSettings& settings, const std::string& key, const std::string& value) {
    switch (owner_of(key)) {
        case KeyOwner::Grabber:
            return refuse_decimation(key, value);
        case KeyOwner::Camera:
            settings.camera_keys[lowerCase(key)] = value;
            return;
        case KeyOwner::Producer:
            return set_producer_value(settings, key, value);
        case KeyOwner::Flownav:
            return config::set_config_value(settings.config, lowerCase(key), value);
        case KeyOwner::Nobody:
            throw config::ConfigError("unknown key " + key + "; the nearest known key is " +
                                      nearest_producer_key(key));
    }
}

/// Key that holds the source of a grabber's images; empty for cameras.
std::string source_key(const std::string& grabber_type) {
    if (grabber_type == "rawlog") return "rawlog_file";
    if (grabber_type == "ffmpeg") return "ffmpeg_url";
    if (grabber_type == "image_dir") return "image_dir_url";
    return "";
}

std::string source_of(const ProducerSettings& settings) {
    const std::string key = source_key(settings.grabber_type);
    if (key.empty()) return "the camera (grabber_type = " + settings.grabber_type + ")";
    const auto found = settings.camera_keys.find(key);
    if (found == settings.camera_keys.end() || found->second.empty()) {
        throw config::ConfigError(key + " is missing: grabber_type = " + settings.grabber_type +
                                  " reads from there");
    }
    return found->second;
}

ProducerSettings read(const CConfigFileBase& ini, const std::string& section) {
    ProducerSettings settings;
    settings.section = section;
    settings.grabber_type = lowerCase(text_of(ini, section, "grabber_type"));
    if (settings.grabber_type.empty()) {
        throw config::ConfigError("grabber_type is missing (opencv, ffmpeg, image_dir, rawlog, ...)");
    }
    settings.camera_keys["grabber_type"] = settings.grabber_type;
    const std::string config_file = text_of(ini, section, "flownav_config");
    if (!config_file.empty()) config::load_config_file(settings.config, config_file);
    const std::string label = text_of(ini, section, "rawlog_camera_sensor_label");
    if (!label.empty()) settings.config.camera.camera_label = label;
    for (const std::string& key : keys_of(ini, section)) set_key(settings, key, text_of(ini, section, key));
    config::check_contacts(settings.config);
    config::check_map(settings.config);
    settings.source = source_of(settings);
    return settings;
}

/// The only section with driver = CFlowObstacleSensor. Throws ConfigError when there is none, or several.
std::string only_section(const CConfigFileBase& ini, const std::string& file) {
    std::vector<std::string> sections;
    ini.getAllSections(sections);
    const auto other_driver = [&](const std::string& section) {
        return text_of(ini, section, "driver") != "CFlowObstacleSensor";
    };
    sections.erase(std::remove_if(sections.begin(), sections.end(), other_driver), sections.end());
    if (sections.empty()) throw config::ConfigError(file + ": no section has driver = CFlowObstacleSensor");
    if (sections.size() > 1) {
        throw config::ConfigError(file + ": both " + sections[0] + " and " + sections[1] +
                                  " have driver = CFlowObstacleSensor; name one of them");
    }
    return sections.front();
}

}  // namespace

ProducerSettings read_producer_settings(const CConfigFileBase& ini, const std::string& section) {
    if (!ini.sectionExists(section)) throw config::ConfigError("there is no section " + section);
    try {
        return read(ini, section);
    } catch (const config::ConfigError& error) {
        throw config::ConfigError("section " + section + ": " + error.what());
    }
}

ProducerSettings read_producer_settings(const std::string& ini_file, const std::string& section) {
    if (!std::filesystem::is_regular_file(ini_file)) throw config::ConfigError(ini_file + ": no such file");
    const mrpt::config::CConfigFileMemory ini(mrpt::io::file_get_contents(ini_file));
    const std::string wanted = section.empty() ? only_section(ini, ini_file) : section;
    try {
        return read_producer_settings(ini, wanted);
    } catch (const config::ConfigError& error) {
        throw config::ConfigError(ini_file + ": " + error.what());
    }
}

}  // namespace flownav::io
