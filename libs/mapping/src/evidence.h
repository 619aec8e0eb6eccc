#pragma once

#include <Eigen/Core>
#include <vector>

#include "flownav/mapping/fusion.h"

namespace flownav {

/// Where a cell of a grid begins, and how large it is.
struct CellFrame {
    Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
    double cell_m = 0.1;

    Eigen::Vector2i cell_of(const Eigen::Vector2d& p_m) const {
        return ((p_m - origin_m) / cell_m).array().floor().cast<int>();
    }
};

/// Probability of being free of a cell that a mover was seen in: it will be elsewhere in the next cycle, so
/// that one sight must do.
constexpr double p_free_of_mover = 0.2;

/// Everything a set says about the cells of a frame, in the order of the cells; movers are left out.
/// T_frame_robot: where the set was seen from.
void gather_evidence(const ObstacleSet& set, const Pose2& T_frame_robot, const CellFrame& frame,
                     std::vector<Evidence>& evidence);

}  // namespace flownav
