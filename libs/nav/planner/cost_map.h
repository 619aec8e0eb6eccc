#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "flownav/math/grid2d.h"
#include "flownav/nav/planner.h"

namespace flownav::nav {

/// What a metre of way costs in each cell, in metres.
class CostMap {
  public:
    CostMap(const mrpt::maps::COccupancyGridMap2D& map, const GridArea& area, const RobotModel& robot,
            const PlanParams& params);

    const GridArea& area() const { return area_; }
    float cost(const Eigen::Vector2i& cell) const { return cost_.at<float>(cell.y(), cell.x()); }
    /// No robot fits there.
    bool is_closed(const Eigen::Vector2i& cell) const { return cost(cell) >= closed; }
    /// There stands something.
    bool is_obstacle(const Eigen::Vector2i& cell) const { return cost(cell) >= obstacle; }

    static constexpr float closed = 100.0F;
    static constexpr float obstacle = 1000.0F;

  private:
    GridArea area_;
    cv::Mat cost_;
};

/// The rectangle that holds the map, both points, and a margin; cut to params.area_max_m about `from_m`.
GridArea area_around(const mrpt::maps::COccupancyGridMap2D& map, const Eigen::Vector2d& from_m,
                     const Eigen::Vector2d& goal_m, const PlanParams& params);

}  // namespace flownav::nav
