#pragma once

#include <Eigen/Core>
#include <vector>

#include "flownav/mapping/fusion.h"

namespace flownav {

/// What one set says about one cell. A cell hears of each set once, however many vectors fell into it.
struct Evidence {
    Eigen::Vector2i cell;  ///< floor((position - origin) / edge of a cell)
    double p_free;         ///< MRPT's cells speak of the probability of being FREE

    bool operator<(const Evidence& o) const {
        if (cell.x() != o.cell.x()) return cell.x() < o.cell.x();
        if (cell.y() != o.cell.y()) return cell.y() < o.cell.y();
        return p_free < o.p_free;  // the surest obstacle first: it wins over floor in the same cell
    }
    bool operator==(const Evidence& o) const { return cell == o.cell; }
};

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
std::vector<Evidence> evidence_of(const ObstacleSet& set, const Pose2& T_frame_robot, const CellFrame& frame);

}  // namespace flownav
