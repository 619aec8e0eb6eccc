#include "sensor_setup.h"

#include <mrpt/config/CConfigFileMemory.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "flownav/cli/usage_error.h"

namespace flownav {

namespace {

using mrpt::hwdrivers::CGenericSensor;

constexpr const char* global = "global";

/// Loads into memory, because CConfigFile would rewrite the user's file.
mrpt::config::CConfigFileMemory loaded(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
        throw cli::UsageError("cannot read the configuration " + file.string());
    mrpt::config::CConfigFileMemory ini;
    ini.setContent(std::string(std::istreambuf_iterator<char>(stream), {}));
    return ini;
}

SensorSetup configured(const mrpt::config::CConfigFileBase& ini, const std::string& section) {
    const std::string where = "[" + section + "]: ";
    const std::string driver = ini.read_string(section, "driver", "");
    if (driver.empty()) throw cli::UsageError(where + "needs the key driver, the class of the sensor");
    auto sensor = CGenericSensor::createSensorPtr(driver);
    if (!sensor) {
        throw cli::UsageError(where + "driver = " + driver +
                              " is not known; drivers of other libraries come with --plugin FILE.so");
    }
    try {
        sensor->loadConfig(ini, section);
    } catch (const std::exception& error) {
        throw cli::UsageError(where + plain_sentence(error.what()));
    }
    const double rate_hz = sensor->getProcessRate();
    if (!std::isfinite(rate_hz) || rate_hz <= 0) {
        throw cli::UsageError(where + "process_rate must be above 0, the calls a second");
    }
    return {section, driver, std::move(sensor)};
}

void read_global(const mrpt::config::CConfigFileBase& ini, GrabSetup& setup) {
    setup.gz_level = ini.read_int(global, "rawlog_GZ_compress_level", setup.gz_level);
    if (setup.gz_level < 0 || setup.gz_level > 9) {
        throw cli::UsageError("[global]: rawlog_GZ_compress_level = " + std::to_string(setup.gz_level) +
                              " is out of range (0 .. 9)");
    }
    const double wait_ms = ini.read_double(global, "time_between_launches", 0);
    if (!(wait_ms >= 0 && wait_ms <= 60000)) {
        throw cli::UsageError("[global]: time_between_launches must be 0 .. 60000 milliseconds");
    }
    setup.time_between_launches_s = wait_ms / 1000;
    if (ini.read_bool(global, "use_sensoryframes", false)) {
        setup.warnings.emplace_back(
            "[global]: use_sensoryframes is not followed, the recording is a list of observations");
    }
}

}  // namespace

GrabSetup read_grab_setup(const std::filesystem::path& ini_file) {
    const auto ini = loaded(ini_file);
    GrabSetup setup;
    read_global(ini, setup);
    std::vector<std::string> sections;
    ini.getAllSections(sections);
    for (const std::string& section : sections) {
        if (section == global || section.empty()) continue;
        if (ini.read_bool(section, "rawlog-grabber-ignore", false)) continue;
        setup.sensors.push_back(configured(ini, section));
    }
    if (setup.sensors.empty()) {
        throw cli::UsageError(ini_file.string() +
                              " names no sensor: it needs a section with driver and process_rate");
    }
    return setup;
}

std::string plain_sentence(const std::string& what) {
    std::istringstream lines(what);
    std::string line;
    while (std::getline(lines, line)) {
        const std::string mark = "Message:";
        if (line.compare(0, mark.size(), mark) == 0) line.erase(0, mark.size());
        const auto begin = line.find_first_not_of(" \t");
        if (begin == std::string::npos || line.compare(0, 4, "====") == 0) continue;
        return line.substr(begin);
    }
    return "an error without a message";
}

}  // namespace flownav
