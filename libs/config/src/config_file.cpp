#include <mrpt/io/vector_loadsave.h>

#include <filesystem>

#include "flownav/config/config.h"
#include "ini_text.h"

namespace flownav::config {
namespace {

std::string read_text(const std::string& path) {
    if (!std::filesystem::exists(path)) throw ConfigError(path + ": no such file");
    if (std::filesystem::is_directory(path)) throw ConfigError(path + ": is a folder, expected an ini file");
    try {
        return mrpt::io::file_get_contents(path);
    } catch (const std::exception&) {
        throw ConfigError(path + ": cannot be read");
    }
}

}  // namespace

void load_config_file(Config& config, const std::string& path) {
    Config loaded = config;
    for (const auto& entry : parse_ini(path, read_text(path))) {
        try {
            set_config_value(loaded, entry.section + "." + entry.name, entry.value);
        } catch (const ConfigError& error) {
            throw ConfigError(path + ":" + std::to_string(entry.line) + ": " + error.what());
        }
    }
    config = loaded;
}

}  // namespace flownav::config
