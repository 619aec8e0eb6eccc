#pragma once
#include <cmath>

#include "flownav/mapping/global_map.h"

namespace flownav::testing {

/// A precise point of the robot frame.
inline ObstaclePoint point_at(double x_m, double y_m, double sigma_m = 0.01) {
    ObstaclePoint point;
    point.position_m = {x_m, y_m, 0.3};
    point.sigma_m = sigma_m;
    return point;
}

/// The measurement of a robot at T_map_robot of an obstacle at (x, y) of the MAP.
inline mapping::ObstacleSet set_seeing(double x_m, double y_m, const Pose2& T_map_robot,
                                       double timestamp_s = 0.0) {
    const Eigen::Vector2d p = transform(inverse(T_map_robot), {x_m, y_m});
    return {timestamp_s, T_map_robot, {point_at(p.x(), p.y())}, {}};
}

/// Probability that a place is occupied; MRPT's cells hold the probability of being free.
inline double occupancy(const mrpt::maps::COccupancyGridMap2D& grid, double x_m, double y_m) {
    return 1.0 - static_cast<double>(grid.getPos(static_cast<float>(x_m), static_cast<float>(y_m)));
}

/// Number of cells above 0.65.
inline int occupied_cells(const mrpt::maps::COccupancyGridMap2D& grid) {
    int count = 0;
    for (int y = 0; y < static_cast<int>(grid.getSizeY()); ++y) {
        for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x)
            count += 1.0 - static_cast<double>(grid.getCell(x, y)) > 0.65;
    }
    return count;
}

}  // namespace flownav::testing
