#pragma once

#include <string>
#include <utility>
#include <vector>

#include "post_drive.h"

namespace flownav::sensor_bench {

/// A camera on a robot.
struct Candidate {
    int width_px = 640;
    int height_px = 480;  ///< height of an image; of a field when interlaced
    bool interlaced = false;
    double rate_hz = 25.0;
    double wide_deg = 90.0;
    double height_m = 0.6;
    double pitch_deg = 18.0;
};

using Settings = std::vector<std::pair<std::string, std::string>>;

/// One row of the table: a camera, a drive, and settings in addition to those of the page.
struct Case {
    std::string name;
    Candidate camera;
    DriveOptions drive;
    Settings settings;
};

struct Section {
    std::string name;
    std::string title;
    std::vector<Case> cases;
};

/// Every section varies one parameter of the first case.
std::vector<Section> all_sections();

/// Settings for post fields that differ from the defaults.
Settings recommended_settings();

sim::CameraSimParams to_simulator(const Candidate& camera);

}  // namespace flownav::sensor_bench
