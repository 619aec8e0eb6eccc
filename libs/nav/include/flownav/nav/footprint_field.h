#pragma once

#include <Eigen/Core>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/math/footprint.h"

namespace flownav::nav {

/// Signed distance to a footprint, < 0 inside, in a raster that is fast to ask.
class FootprintField {
  public:
    /// Exact to about a millimetre up to `reach_m` beyond the footprint.
    FootprintField(const Polygon& footprint_m, double reach_m);

    /// Of a point in the robot's frame; beyond the reach any distance >= the reach.
    double distance_m(const Eigen::Vector2d& p_robot) const {
        const Eigen::Vector2d at = (p_robot - low_m_) / step_m;
        // Compared before they become integers: a far point or NaN is outside, too.
        if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < columns_ - 1 && at.y() < rows_ - 1)) return reach_m_;
        const auto column = static_cast<int>(at.x());
        const auto row = static_cast<int>(at.y());
        const double u = at.x() - column;
        const double w = at.y() - row;
        const float* const d = &distance_m_[static_cast<std::size_t>(row) * columns_ + column];
        return (1 - w) * ((1 - u) * d[0] + u * d[1]) + w * ((1 - u) * d[columns_] + u * d[columns_ + 1]);
    }

    double reach_m() const { return reach_m_; }
    /// Radius about the robot's origin beyond which nothing is within the reach.
    double radius_m() const { return radius_m_; }

  private:
    static constexpr double step_m = 0.01;

    double reach_m_;
    double radius_m_;
    Eigen::Vector2d low_m_;
    int columns_;
    int rows_;
    std::vector<float> distance_m_;
};

}  // namespace flownav::nav
