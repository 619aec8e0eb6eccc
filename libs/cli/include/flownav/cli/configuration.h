#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/flow/kernel.h"

namespace flownav::cli {

/// Sets what each --set section.key=value says. Throws ConfigError.
inline void apply_settings(config::Config& config, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos) {
            throw config::ConfigError("--set " + setting + ": needs the form section.key=value");
        }
        config::set_config_value(config, setting.substr(0, equals), setting.substr(equals + 1));
    }
}

/// The values of `config`, then those of --config, where there is one, then those of each --set
/// section.key=value. Throws ConfigError, for FLOWNAV_KERNEL too.
inline config::Config configuration(const std::string& file, const std::vector<std::string>& settings,
                                    config::Config config = {}) {
    if (!file.empty()) config::load_config_file(config, file);
    apply_settings(config, settings);
    config::check_contacts(config);
    config::check_map(config);
    try {
        flow::default_kernel();
    } catch (const std::runtime_error& error) {
        throw config::ConfigError(error.what());
    }
    return config;
}

}  // namespace flownav::cli
