#pragma once
#include <filesystem>
#include <functional>

#include "flownav/testing/scene.h"

namespace flownav::testing {

/// How the recorded odometry deviates from the truth.
struct OdometryErrors {
    double scale = 1.006;              ///< on distances
    double yaw_scale = 1.01;           ///< on turns
    double distance_sigma_m = 0.0002;  ///< per image
    double yaw_sigma_rad = 0.0003;     ///< per image
};

/// Odometry of a scene: starts at the first true pose.
std::vector<Pose2> make_odometry(const Scene& scene, const OdometryErrors& errors = {});

struct WriteOptions {
    int gz_level = 6;
    OdometryErrors odometry;
    std::function<void(int done, int all)> progress;  ///< after every image; may be empty
};

/// Writes BASENAME.rawlog (per image ODOMETRY, GROUND_TRUTH and CAMERA1, gz), BASENAME.gt.csv,
/// BASENAME.objects.csv and, when something moves, BASENAME.movers.csv.
/// Throws std::runtime_error naming the file that cannot be written.
void write_scene(const Scene& scene, const std::filesystem::path& basename, const WriteOptions& options = {});

}  // namespace flownav::testing
