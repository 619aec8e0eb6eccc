#pragma once
#include <mrpt/hwdrivers/CGenericSensor.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace flownav {

/// The ini or the command line makes no sense; what() says what to change.
struct GrabUsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// One section of the ini: a sensor that is configured, but not yet started.
struct SensorSetup {
    std::string section;
    std::string driver;
    mrpt::hwdrivers::CGenericSensor::Ptr sensor;
};

/// What an ini of rawlog-grabber asks for.
struct GrabSetup {
    std::vector<SensorSetup> sensors;
    int gz_level = 1;                    ///< [global] rawlog_GZ_compress_level
    double time_between_launches_s = 0;  ///< [global] time_between_launches, milliseconds in the ini
    std::vector<std::string> warnings;   ///< keys of [global] that are not followed
};

/// Makes and configures the sensors of every section, except [global] and those with
/// rawlog-grabber-ignore = true. Throws GrabUsageError: no such file, no sensor, an unknown driver, or
/// what a driver says about its keys.
GrabSetup read_grab_setup(const std::filesystem::path& ini_file);

/// The sentence of an exception of MRPT, without its marks and its call stack.
std::string plain_sentence(const std::string& what);

}  // namespace flownav
