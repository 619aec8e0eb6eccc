#pragma once
#include <Eigen/Core>

#include "flownav/flow/kernel.h"
#include "flownav/flow/params.h"

namespace flownav {

/// Offset of the true minimum from the integer one, in -0.5..0.5 px, from the costs before, at and behind it.
/// V: two lines of opposite slope through the three, right for a SAD; parabola: right for squared
/// differences. 0 where a neighbour is missing or the surface is flat.
double refine(int before, int at, int behind, Subpixel how);

/// (mu, nu) of a match, refined along u and v.
Eigen::Vector2d refined_offset_px(const BlockMatch& match, Subpixel how);

/// Standard deviation of the refined offset in u and v: the noise of a SAD, which the minimum itself tells,
/// over the slope beside the minimum. A straight edge has no slope along itself. Measured against exact flow
/// the law sigma = 0.03 + 0.05 minimum / slope holds from 0.05 to 1 px over all floors of tests/support.
Eigen::Vector2d sigma_px_of(const BlockMatch& match);

/// (second - minimum) / second, 0..1; 0 where the minimum lies on the border of its window (a smaller cost
/// may lie outside) or where the window is too small to hold a second one.
double confidence_of(const BlockMatch& match);

}  // namespace flownav
