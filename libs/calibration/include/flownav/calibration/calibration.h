#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "flownav/cli/progress.h"
#include "flownav/config/config.h"
#include "flownav/replay/replay.h"

namespace flownav::calibration {

struct CalibrationOptions {
    std::filesystem::path input;    ///< a rawlog
    std::filesystem::path output;   ///< an ini
    std::filesystem::path picture;  ///< a PNG; empty: none
    config::Config config;          ///< start of the estimation
    bool odometry = false;          ///< estimate the height from the recording's odometry
    cli::Progress::Style progress = cli::Progress::Style::Silent;
};

/// One value of the camera's pose.
struct CalibratedValue {
    std::string key;  ///< key of the ini, such as pitch_deg
    const char* unit;
    double before;
    double after;
    double sigma;
    bool determined;  ///< false: the drive does not determine it; `before` is kept
};

/// Text such as "pitch_deg = 24.9000 deg, uncertainty 0.0100, before 25.0000 deg".
std::string describe(const CalibratedValue& value);

enum class CalibrationStatus {
    Fine = 0,
    Usage = 1,          ///< bad usage or configuration; no file was written
    Input = 2,          ///< the input is damaged or ended early; its readable part was used
    Output = 3,         ///< output could not be written
    NotDetermined = 4,  ///< the drive does not determine the pitch; no file was written
};

struct CalibrationResult {
    CalibrationStatus status = CalibrationStatus::Fine;
    std::string message;                  ///< problem and advice; empty when there is none
    std::vector<CalibratedValue> values;  ///< pitch, roll, yaw, height
    std::vector<std::string> notes;       ///< notes about data, residuals and advice, one line each
};

/// Estimates the pose of the camera from a drive and writes it as an ini. Reports bad input and full disks in
/// the result; does not throw on them.
CalibrationResult calibrate(const CalibrationOptions& options);

}  // namespace flownav::calibration
