#pragma once

namespace flownav::obstacles {

struct ObstacleParams {
    double tau_px = 1.25;       ///< Eq. (13): how much longer than on the ground a vector must be
    double lambda_px = 1.0;     ///< Eq. (11): largest distance of a vector from its line through the FOE
    int neighbours = 2;         ///< neighbouring blocks that must agree with an obstacle
    double range_max_m = 8.0;   ///< points farther away are not reported
    double height_max_m = 2.0;  ///< points higher above the ground are not reported
    double beam_deg = 2.0;      ///< width of one beam of the virtual scan
};

}  // namespace flownav::obstacles
