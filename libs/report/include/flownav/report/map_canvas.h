#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/math/footprint.h"

namespace flownav::report {

/// A picture of the ground from above (8-bit BGR): x to the right, y up. Lines and circles are drawn at
/// fractions of a pixel. Grey where no map was drawn.
class MapCanvas {
  public:
    /// `at_m` is shown at `at_px`, in pixels from the left and the upper edge.
    MapCanvas(const Eigen::Vector2d& at_m, const Eigen::Vector2d& at_px, double px_per_m,
              const cv::Size& size_px);

    /// White is free, black occupied, grey unknown.
    void draw_map(const mrpt::maps::COccupancyGridMap2D& grid);
    void draw_line(const std::vector<Eigen::Vector2d>& points_m, const cv::Scalar& colour, int width_px);
    void draw_outline(const Polygon& corners_m, const cv::Scalar& colour, int width_px);
    void fill(const Polygon& corners_m, const cv::Scalar& colour);
    /// `width_px` may be cv::FILLED.
    void draw_circle(const Eigen::Vector2d& middle_m, double radius_px, const cv::Scalar& colour,
                     int width_px);

    double px_per_m() const { return px_per_m_; }
    /// The pixels drawn so far; drawing on them draws on the canvas.
    cv::Mat& picture() { return picture_; }

  private:
    Eigen::Vector2d pixel_of(const Eigen::Vector2d& place_m) const;
    Eigen::Vector2d place_of(const Eigen::Vector2d& px) const;
    cv::Point fixed(const Eigen::Vector2d& place_m) const;
    std::vector<cv::Point> fixed(const std::vector<Eigen::Vector2d>& places_m) const;

    Eigen::Vector2d at_m_;
    Eigen::Vector2d at_px_;
    double px_per_m_;
    cv::Mat picture_;
};

/// The positions of poses, for draw_line().
std::vector<Eigen::Vector2d> positions_m(const std::vector<Pose2>& poses);

}  // namespace flownav::report
