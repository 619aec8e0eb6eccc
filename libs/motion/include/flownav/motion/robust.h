#pragma once
#include <vector>

namespace flownav::motion {

/// Eq. (6): centre of the shortest interval that holds half of the values. The first of several equally short
/// ones; 0 for no values, the value for one, the mean for two. Sorts `values`.
double shorth(std::vector<double>& values);

/// Median of absolute values, times 1.4826: the standard deviation if they were Gaussian. Reorders `values`.
double robust_deviation(std::vector<double>& values);

/// Tukey's biweight for a residual in units of its scale: 1 at 0, 0 from 4.685 on.
double biweight(double residual);

}  // namespace flownav::motion
