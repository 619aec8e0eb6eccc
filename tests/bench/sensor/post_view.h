#pragma once

#include "post_drive.h"

namespace flownav::sensor_bench {

/// Distance of a point to the surface of a post, seen from above; < 0 inside.
double surface_distance_m(const Post& post, const Eigen::Vector2d& at_m);

/// Visible share of a post in an image: within the image, and not behind another post. Samples its front from
/// 5 cm above the ground to 5 cm below its top.
double visible_share(const RecordedDrive& drive, std::size_t post, std::size_t image);

/// Range, from the robot's axis, of the surface of `post` along the line from the camera through a point of
/// the robot frame. A line that passes the post within `margin_rad` meets its edge. Negative when the line
/// misses it.
double range_along_m(const RecordedDrive& drive, std::size_t post, std::size_t image,
                     const Eigen::Vector2d& point_robot_m, double margin_rad);

}  // namespace flownav::sensor_bench
