#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "flownav/nav/planner.h"

namespace flownav::nav {

/// A rectangle of the ground in cells; x to the right, y up.
struct CellArea {
    Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< corner of cell (0, 0)
    double cell_m = 0.05;
    int columns = 0;
    int rows = 0;

    bool contains(const Eigen::Vector2i& cell) const {
        return cell.x() >= 0 && cell.y() >= 0 && cell.x() < columns && cell.y() < rows;
    }
    Eigen::Vector2i cell_of(const Eigen::Vector2d& p_m) const {
        return ((p_m - origin_m) / cell_m).array().floor().cast<int>();
    }
    Eigen::Vector2d middle_of(const Eigen::Vector2i& cell) const {
        return origin_m + (cell.cast<double>() + Eigen::Vector2d(0.5, 0.5)) * cell_m;
    }
    int index(const Eigen::Vector2i& cell) const { return cell.y() * columns + cell.x(); }
};

/// What a metre of way costs in each cell, in metres.
class CostMap {
  public:
    CostMap(const mrpt::maps::COccupancyGridMap2D& map, const CellArea& area, const RobotModel& robot,
            const PlanParams& params);

    const CellArea& area() const { return area_; }
    float cost(const Eigen::Vector2i& cell) const { return cost_.at<float>(cell.y(), cell.x()); }
    /// No robot fits there.
    bool is_closed(const Eigen::Vector2i& cell) const { return cost(cell) >= closed; }
    /// There stands something.
    bool is_obstacle(const Eigen::Vector2i& cell) const { return cost(cell) >= obstacle; }

    static constexpr float closed = 100.0F;
    static constexpr float obstacle = 1000.0F;

  private:
    CellArea area_;
    cv::Mat cost_;
};

/// The rectangle that holds the map, both points, and a margin; cut to params.area_max_m about `from_m`.
CellArea area_around(const mrpt::maps::COccupancyGridMap2D& map, const Eigen::Vector2d& from_m,
                     const Eigen::Vector2d& goal_m, const PlanParams& params);

}  // namespace flownav::nav
