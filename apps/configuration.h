#pragma once
#include <string>
#include <vector>

#include "flownav/sensor/config.h"

namespace flownav {

/// The defaults, then the values of --config, where there is one, then those of each --set section.key=value.
/// Throws ConfigError.
inline Config configuration(const std::string& file, const std::vector<std::string>& settings) {
    Config config;
    if (!file.empty()) load_config_file(config, file);
    for (const std::string& setting : settings) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos) {
            throw ConfigError("--set " + setting + ": needs the form section.key=value");
        }
        set_config_value(config, setting.substr(0, equals), setting.substr(equals + 1));
    }
    return config;
}

}  // namespace flownav
