#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/sim/camera_simulator.h"

namespace flownav::sensor_bench {

/// Appearance of the posts, which determines how hard they are to see.
enum class PostLook { Textured, LowTexture, Silhouette };
const char* to_string(PostLook look);

/// A drive through a field of posts: straight, or weaving with turns of a constant rate to either side.
struct DriveOptions {
    double speed_mps = 0.8;
    double turn_radps = 0.3;
    double seconds = 12.0;
    PostLook look = PostLook::Textured;
    sim::Surface floor = sim::Surface::Carpet;
    double post_height_m = 0.5;  ///< above the ground
    std::uint64_t seed = 1;
};

struct Post {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    double radius_m = 0.075;
    double height_m = 0.5;
};

/// A recorded drive; image i was taken at poses[i] with the turn rate turn_radps[i].
struct RecordedDrive {
    DriveOptions options;
    CameraMount mount;
    std::vector<Post> posts;
    std::vector<Pose2> poses;
    std::vector<double> turn_radps;
    std::vector<Field> fields;
};

/// Places the posts, drives and renders.
RecordedDrive record(const DriveOptions& options, const sim::CameraSimParams& camera);

}  // namespace flownav::sensor_bench
