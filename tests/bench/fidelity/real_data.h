#pragma once
#include <filesystem>
#include <string>

#include "flownav/evaluation/metrics.h"
#include "lidar_score.h"

namespace flownav::fidelity {

struct RealDataOptions {
    std::filesystem::path data;      ///< empty: $FLOWNAV_DATA, or shared/data beside the project
    std::filesystem::path plan_svg;  ///< plan of the braking drive; empty: not drawn
    std::filesystem::path pictures;  ///< folder for camera images with points and lidar on them; empty: none
};

/// Result of KITTI odometry, sequence 00, with ini/kitti.ini.
struct OdometryScore {
    Share ok;           ///< images after the first whose turn rate was measured
    int first_ok = -1;  ///< index of the first of these images; -1: none
    evaluation::Errors errors;
};

/// Result of a DonkeyCar with ini/donkeycar.ini against its gyro, over the images whose turn is known.
struct GyroScore {
    Share ok;     ///< images after the first whose turn the flow measured
    Share known;  ///< images after the first whose turn the flow measured or the gyro told
    double correlation = nothing_measured;
    Moments difference_degps;
    double median_difference_degps = nothing_measured;
};

// Each takes the folder of its data set. Throw std::runtime_error naming a damaged file.
LidarScore braking_score(const std::filesystem::path& folder, const RealDataOptions& options);
OdometryScore odometry_score(const std::filesystem::path& folder);
/// `use`: what the gyro is used for besides the comparison.
GyroScore gyro_score(const std::filesystem::path& folder, pipeline::SensorUse use);

/// Returns $FLOWNAV_DATA, or shared/data beside the project.
std::filesystem::path data_folder();

/// Returns the results of the chain on recordings of real drives, in markdown, with a note for each missing
/// recording. Throws std::runtime_error naming a file that is damaged or cannot be written.
std::string real_data_report(const RealDataOptions& options);

// Parts of the report.
std::string braking_part(const std::filesystem::path& folder, const RealDataOptions& options);
std::string odometry_part(const std::filesystem::path& folder);
std::string gyro_part(const std::filesystem::path& folder);

}  // namespace flownav::fidelity
