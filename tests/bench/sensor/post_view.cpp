#include "post_view.h"

#include <cmath>

#include "flownav/core/camera_model.h"

namespace flownav::sensor_bench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double border_px = 8.0;

/// Transforms a point of the robot frame to the level camera: x right, y down, z ahead along its axis.
Vector3d in_level_camera(const CameraMount& mount, const Vector3d& robot_m) {
    const Vector3d d = robot_m - Vector3d(mount.forward_m, mount.left_m, mount.height_m);
    const double c = std::cos(mount.pitch_rad);
    const double s = std::sin(mount.pitch_rad);
    return {-d.y(), -s * d.x() - c * d.z(), c * d.x() - s * d.z()};
}

bool in_image(const RayMapper& mapper, const Vector3d& robot_m) {
    const CameraModel& camera = mapper.camera();
    const Vector3d p = in_level_camera(camera.mount, robot_m);
    if (p.z() < 0.05) return false;
    const Vector2d pixel = mapper.pixel(p.hnormalized());
    return pixel.x() > border_px && pixel.y() > border_px && pixel.x() < camera.width_px - 1 - border_px &&
           pixel.y() < camera.height_px - 1 - border_px;
}

/// True when a post stands between two points.
bool hides(const Post& post, const Vector3d& eye_m, const Vector3d& at_m) {
    const Vector2d along = (at_m - eye_m).head<2>();
    const Vector2d to_post = post.at_m - eye_m.head<2>();
    const double share = to_post.dot(along) / along.squaredNorm();
    if (share <= 0.0 || share >= 1.0) return false;
    if ((to_post - share * along).norm() > post.radius_m) return false;
    return eye_m.z() + share * (at_m.z() - eye_m.z()) < post.height_m;
}

Vector2d camera_at(const RecordedDrive& drive, std::size_t image) {
    return transform(drive.poses[image], {drive.mount.forward_m, drive.mount.left_m});
}

}  // namespace

double surface_distance_m(const Post& post, const Vector2d& at_m) {
    return (post.at_m - at_m).norm() - post.radius_m;
}

double visible_share(const RecordedDrive& drive, std::size_t index, std::size_t image) {
    const Post& post = drive.posts[index];
    const RayMapper mapper(drive.fields[image].camera);
    const Vector2d eye = camera_at(drive, image);
    const Vector3d eye_m(eye.x(), eye.y(), drive.mount.height_m);
    const Vector2d toward = (eye - post.at_m).normalized();
    const Vector2d side(-toward.y(), toward.x());
    int seen = 0;
    int all = 0;
    for (double height = 0.05; height < post.height_m - 0.04; height += 0.08) {
        for (const double across : {-0.7, 0.0, 0.7}) {
            ++all;
            const Vector2d at =
                post.at_m + post.radius_m * (across * side + std::sqrt(1 - across * across) * toward);
            const Vector3d at_m(at.x(), at.y(), height);
            const Vector2d robot = transform(inverse(drive.poses[image]), at);
            if (!in_image(mapper, {robot.x(), robot.y(), height})) continue;
            bool hidden = false;
            for (std::size_t other = 0; other < drive.posts.size() && !hidden; ++other)
                hidden = other != index && hides(drive.posts[other], eye_m, at_m);
            seen += hidden ? 0 : 1;
        }
    }
    return all > 0 ? static_cast<double>(seen) / all : 0.0;
}

double range_along_m(const RecordedDrive& drive, std::size_t index, std::size_t image,
                     const Vector2d& point_robot_m, double margin_rad) {
    const Post& post = drive.posts[index];
    const Vector2d eye = camera_at(drive, image);
    const Vector2d along = (transform(drive.poses[image], point_robot_m) - eye).normalized();
    const Vector2d to_post = post.at_m - eye;
    const double ahead = to_post.dot(along);
    const double beside = std::abs(to_post.x() * along.y() - to_post.y() * along.x());
    if (ahead <= 0.0 || beside > post.radius_m + margin_rad * ahead) return -1.0;
    const double inside = std::min(beside, post.radius_m);
    const double depth = ahead - std::sqrt(post.radius_m * post.radius_m - inside * inside);
    return transform(inverse(drive.poses[image]), eye + depth * along).norm();
}

}  // namespace flownav::sensor_bench
