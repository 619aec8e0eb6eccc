#pragma once
#include <mrpt/hwdrivers/CGenericSensor.h>

#include <filesystem>
#include <string>
#include <vector>

namespace flownav {

/// One section of the ini: a sensor that is configured, but not yet started.
struct SensorSetup {
    std::string section;
    std::string driver;
    mrpt::hwdrivers::CGenericSensor::Ptr sensor;
};

/// Contents of an ini of rawlog-grabber.
struct GrabSetup {
    std::vector<SensorSetup> sensors;
    int gz_level = 1;                    ///< [global] rawlog_GZ_compress_level
    double time_between_launches_s = 0;  ///< [global] time_between_launches, milliseconds in the ini
    std::vector<std::string> warnings;   ///< keys of [global] that are ignored
};

/// Makes and configures the sensors of every section, except [global] and those with
/// rawlog-grabber-ignore = true. Throws UsageError: no such file, no sensor, an unknown driver, or
/// what a driver says about its keys.
GrabSetup read_grab_setup(const std::filesystem::path& ini_file);

/// Extracts the message of an MRPT exception, without decoration and call stack.
std::string plain_sentence(const std::string& what);

}  // namespace flownav
