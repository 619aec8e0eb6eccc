#pragma once
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "flownav/evaluation/pose_fit.h"

namespace flownav::report {

/// Mean disagreement of the floor's vectors with the ground plane, in cells of the image.
struct ResidualField {
    struct Cell {
        Eigen::Vector2d at_px, residual_px;
    };
    std::vector<Cell> cells;  ///< those with enough vectors
    double median_px = 0.0;   ///< of the lengths of the cells' residuals
};

/// Residuals with a first and a second correction, over the vectors that are floor with the second.
struct ResidualComparison {
    ResidualField before, after;
};

ResidualComparison compare_residuals(const std::vector<evaluation::CalibrationPair>& pairs,
                                     const motion::MountAngles& before_rad,
                                     const motion::MountAngles& after_rad);

/// The two side by side as arrows on a dimmed field (8-bit BGR), each under its title.
cv::Mat residual_picture(const Field& background, const ResidualComparison& residuals,
                         const std::string& before_title, const std::string& after_title);

}  // namespace flownav::report
