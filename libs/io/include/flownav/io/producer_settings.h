#pragma once
#include <mrpt/config/CConfigFileBase.h>

#include <map>
#include <optional>
#include <string>

#include "flownav/config/config.h"

namespace flownav::io {

/// One section of an ini of rawlog-grabber whose driver is CFlowObstacleSensor; CFlowObstacleSensor lists
/// its keys.
struct ProducerSettings {
    std::string section;
    config::Config config;                           ///< of flownav
    std::string grabber_type;                        ///< in lower case
    std::string source;                              ///< file, folder, URL or camera, for messages
    std::map<std::string, std::string> camera_keys;  ///< those of MRPT's CCameraSensor
    std::string label_prefix = "FLOW";
    bool use_odometry = true;  ///< of a rawlog
    bool publish_image = false;
    bool paced = false;
    std::optional<double> rate_hz;  ///< of files and folders; empty: as the file says
    double start_time_s = 0.0;      ///< since the epoch: the first image of files and folders
    double end_wait_s = 5.0;
};

/// Reads a section. Throws ConfigError: a key that is unknown (names the nearest known one), unparsable or
/// out of range, or one that the grabber needs and that is missing.
ProducerSettings read_producer_settings(const mrpt::config::CConfigFileBase& ini, const std::string& section);

/// The same from a file; without `section` its only section with driver = CFlowObstacleSensor. Throws
/// ConfigError also when the file cannot be read, or has no such section or several.
ProducerSettings read_producer_settings(const std::string& ini_file, const std::string& section = "");

}  // namespace flownav::io
