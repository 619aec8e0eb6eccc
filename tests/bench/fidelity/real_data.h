#pragma once
#include <filesystem>
#include <string>

#include "flownav/evaluation/metrics.h"
#include "lidar_score.h"

namespace flownav::fidelity {

struct RealDataOptions {
    std::filesystem::path data;      ///< empty: $FLOWNAV_DATA, or shared/data beside the project
    std::filesystem::path plan_svg;  ///< empty: no plan of the braking drive is drawn
    std::filesystem::path pictures;  ///< folder for camera images with points and lidar on them; empty: none
};

/// KITTI odometry, sequence 00, with ini/kitti.ini.
struct OdometryScore {
    Share ok;           ///< images after the first whose turn was measured
    int first_ok = -1;  ///< number of the first of them; -1: none
    evaluation::Errors errors;
};

/// A DonkeyCar with ini/donkeycar.ini against its gyro.
struct GyroScore {
    Share ok;
    double correlation = nothing_measured;
    Moments difference_degps;
    double median_difference_degps = nothing_measured;
};

// Each is told the folder of its data set. Throw std::runtime_error naming a file that is damaged.
LidarScore braking_score(const std::filesystem::path& folder, const RealDataOptions& options);
OdometryScore odometry_score(const std::filesystem::path& folder);
GyroScore gyro_score(const std::filesystem::path& folder);

/// $FLOWNAV_DATA, or shared/data beside the project.
std::filesystem::path data_folder();

/// What the chain makes of recordings of real drives, in markdown. Says so where one is missing.
/// Throws std::runtime_error naming a file that is damaged or cannot be written.
std::string real_data_report(const RealDataOptions& options);

// Its parts.
std::string braking_part(const std::filesystem::path& folder, const RealDataOptions& options);
std::string odometry_part(const std::filesystem::path& folder);
std::string gyro_part(const std::filesystem::path& folder);

}  // namespace flownav::fidelity
