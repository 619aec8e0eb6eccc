#pragma once
#include <vector>

namespace flownav::motion {

/// Eq. (6): centre of the shortest interval that holds half of the values. Of several equally short intervals
/// the first counts. Returns 0 for no values, the value for one, the mean for two. Sorts `values`.
double shorth(std::vector<double>& values);

/// Returns 1.4826 times the median of the absolute values, which is the standard deviation of Gaussian
/// values; 0 for no values. Replaces `values` by their absolute values and reorders them.
double robust_deviation(std::vector<double>& values);

/// Tukey's biweight of a residual in units of its scale: 1 at 0, and 0 at 4.685 and above.
double biweight(double residual);

}  // namespace flownav::motion
