#pragma once
#include <filesystem>
#include <string>

namespace flownav::fidelity {

struct RealDataOptions {
    std::filesystem::path data;      ///< empty: $FLOWNAV_DATA, or shared/data beside the project
    std::filesystem::path plan_svg;  ///< empty: no plan of the braking drive is drawn
    std::filesystem::path pictures;  ///< folder for camera images with points and lidar on them; empty: none
};

/// What the chain makes of recordings of real drives, in markdown. Says so where one is missing.
/// Throws std::runtime_error naming a file that is damaged or cannot be written.
std::string real_data_report(const RealDataOptions& options);

// Its parts. Each is told the folder of its own data set.
std::string braking_part(const std::filesystem::path& folder, const RealDataOptions& options);
std::string odometry_part(const std::filesystem::path& folder);
std::string gyro_part(const std::filesystem::path& folder);

}  // namespace flownav::fidelity
