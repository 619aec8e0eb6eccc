#pragma once
#include <mrpt/config/CConfigFileBase.h>

#include <map>
#include <optional>
#include <string>

#include "flownav/config/config.h"

namespace flownav::io {

/// Settings from one section of a rawlog-grabber ini with driver = CFlowObstacleSensor, which documents the
/// keys.
struct ProducerSettings {
    std::string section;
    config::Config config;                           ///< configuration of the sensing chain
    std::string grabber_type;                        ///< in lower case
    std::string source;                              ///< file, folder, URL or camera, for messages
    std::map<std::string, std::string> camera_keys;  ///< keys passed on to MRPT's CCameraSensor
    std::string label_prefix = "FLOW";
    bool use_odometry = true;  ///< publish the odometry of a rawlog
    bool publish_image = false;
    bool paced = false;
    std::optional<double> rate_hz;  ///< of videos and folders; empty: as stored in the file
    double start_time_s = 0.0;      ///< time of the first image of videos and folders, since the epoch
    double end_wait_s = 5.0;
};

/// Reads a section. Throws ConfigError: a key is unknown (names the nearest known one), unparsable, out of
/// range, or missing.
ProducerSettings read_producer_settings(const mrpt::config::CConfigFileBase& ini, const std::string& section);

/// Reads a section of a file; an empty `section` selects the only one with driver = CFlowObstacleSensor.
/// Throws ConfigError also when the file cannot be read, or has no such section or several.
ProducerSettings read_producer_settings(const std::string& ini_file, const std::string& section = "");

}  // namespace flownav::io
