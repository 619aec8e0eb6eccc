#include "post_drive.h"

#include <algorithm>
#include <cmath>

#include "flownav/sim/random.h"

namespace flownav::sensor_bench {
namespace {

using Eigen::Vector2d;

constexpr double step_s = 0.001;
constexpr double weave_rad = 0.6;  ///< largest heading to either side
constexpr double alpha_radps2 = 6.0;
constexpr double clear_m = 0.40;  ///< minimum distance between the path and a post
constexpr double beside_m = 3.0;  ///< posts stand within this distance beside the path
constexpr double beyond_m = 4.0;  ///< and beyond its end
constexpr double posts_per_m2 = 0.9;
constexpr double apart_m = 0.25;

struct Moment {
    Pose2 pose;
    double turn_radps = 0.0;
};

/// The drive in steps of 1 ms: turns one way until the heading reaches its limit, then the other way.
std::vector<Moment> weave(const DriveOptions& options) {
    std::vector<Moment> moments;
    Moment now;
    double side = 1.0;
    for (double t = 0.0; t < options.seconds; t += step_s) {
        moments.push_back(now);
        if (side * now.pose.yaw_rad > weave_rad) side = -side;
        const double wanted = side * options.turn_radps;
        const double change =
            std::clamp(wanted - now.turn_radps, -alpha_radps2 * step_s, alpha_radps2 * step_s);
        now.turn_radps += change;
        now.pose = compose(now.pose, along_arc(now.turn_radps * step_s, options.speed_mps * step_s));
    }
    return moments;
}

double distance_to_path_m(const std::vector<Moment>& path, const Vector2d& at_m) {
    double nearest2 = 1e9;
    for (std::size_t i = 0; i < path.size(); i += 20) {
        const Pose2& p = path[i].pose;
        nearest2 = std::min(nearest2, (Vector2d(p.x_m, p.y_m) - at_m).squaredNorm());
    }
    return std::sqrt(nearest2);
}

std::vector<Post> plant(const DriveOptions& options, const std::vector<Moment>& path) {
    double first_m = path.front().pose.x_m;
    double last_m = first_m;
    double right_m = 0.0;
    double left_m = 0.0;
    for (const Moment& m : path) {
        last_m = std::max(last_m, m.pose.x_m);
        right_m = std::min(right_m, m.pose.y_m);
        left_m = std::max(left_m, m.pose.y_m);
    }
    sim::Random random(options.seed);
    std::vector<Post> posts;
    const double area_m2 = (last_m + beyond_m - first_m) * (left_m - right_m + 2 * beside_m);
    const int trials = static_cast<int>(area_m2 * posts_per_m2);
    for (int i = 0; i < trials; ++i) {
        Post post;
        post.height_m = options.post_height_m;
        post.at_m.x() = random.uniform(first_m, last_m + beyond_m);
        post.at_m.y() = random.uniform(right_m - beside_m, left_m + beside_m);
        const bool crowded = std::any_of(posts.begin(), posts.end(), [&](const Post& other) {
            return (other.at_m - post.at_m).norm() < apart_m;
        });
        if (!crowded && distance_to_path_m(path, post.at_m) > clear_m + post.radius_m) posts.push_back(post);
    }
    return posts;
}

sim::Look look_of(const DriveOptions& options, std::uint64_t seed) {
    sim::Random random(seed * 7919 + 13);
    const double grey = std::round(random.uniform(7.0, 16.0)) * 10.0;
    if (options.look == PostLook::LowTexture) return {sim::Surface::Faint, grey, seed};
    if (options.look == PostLook::Silhouette) return {sim::Surface::Plain, grey, seed};
    return {sim::Surface::Patterned, grey, seed};
}

sim::World world_of(const DriveOptions& options, const std::vector<Post>& posts) {
    sim::World world;
    world.floor = {options.floor, 128.0, options.seed};
    for (const Post& post : posts) {
        sim::Solid solid;
        solid.name = "post" + std::to_string(world.solids.size());
        solid.shape = sim::Cylinder{post.radius_m, post.height_m};
        solid.T_world_solid.translation() = Eigen::Vector3d(post.at_m.x(), post.at_m.y(), post.height_m / 2);
        solid.look = look_of(options, options.seed * 1000 + world.solids.size());
        world.solids.push_back(solid);
    }
    return world;
}

}  // namespace

const char* to_string(PostLook look) {
    switch (look) {
        case PostLook::Textured:
            return "textured";
        case PostLook::LowTexture:
            return "low texture";
        case PostLook::Silhouette:
            return "silhouette only";
    }
    return "";
}

RecordedDrive record(const DriveOptions& options, const sim::CameraSimParams& camera) {
    RecordedDrive drive;
    drive.options = options;
    drive.mount = camera.camera.mount;
    const std::vector<Moment> path = weave(options);
    drive.posts = plant(options, path);
    sim::CameraSimulator simulator(world_of(options, drive.posts), camera);
    const int images = static_cast<int>(options.seconds * camera.rate_hz);
    for (int i = 0; i < images; ++i) {
        const double time_s = i / camera.rate_hz;
        const auto moment = static_cast<std::size_t>(std::lround(time_s / step_s));
        if (moment >= path.size()) break;
        drive.poses.push_back(path[moment].pose);
        drive.turn_radps.push_back(path[moment].turn_radps);
        drive.fields.push_back(simulator.take(i, path[moment].pose, time_s));
    }
    return drive;
}

}  // namespace flownav::sensor_bench
