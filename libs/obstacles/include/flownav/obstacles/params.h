#pragma once

#include "flownav/obstacles/contact_params.h"

namespace flownav::obstacles {

struct ObstacleParams {
    double tau_px = 1.25;       ///< Eq. (13): smallest excess over the vector of the ground
    double lambda_px = 1.0;     ///< Eq. (11): largest distance of a vector from its line through the FOE
    int neighbours = 2;         ///< neighbouring candidates of similar depth that an obstacle needs
    double range_max_m = 8.0;   ///< points farther away are not reported
    double height_max_m = 2.0;  ///< points higher above the ground are not reported
    double beam_deg = 2.0;      ///< width of one beam of the virtual scan
    ContactParams contacts;
};

}  // namespace flownav::obstacles
