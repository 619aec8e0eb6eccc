#include "flownav/motion/robust.h"

#include <algorithm>
#include <cmath>

#include "flownav/math/order_statistic.h"

namespace flownav::motion {

double shorth(std::vector<double>& values) {
    const std::size_t n = values.size();
    if (n == 0) return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t k = n / 2;
    std::size_t m = 0;
    for (std::size_t j = 1; j + k < n; ++j) {
        if (values[j + k] - values[j] < values[m + k] - values[m]) m = j;
    }
    // Eq. (6)
    return (values[m] + values[m + k]) / 2;
}

double robust_deviation(std::vector<double>& values) {
    if (values.empty()) return 0.0;
    for (double& v : values) v = std::abs(v);
    return 1.4826 * nth_smallest(values, values.size() / 2);
}

double biweight(double residual) {
    constexpr double tuning = 4.685;  // 95 % efficiency for Gaussian errors
    const double u = residual / tuning;
    if (std::abs(u) >= 1.0) return 0.0;
    const double q = 1.0 - u * u;
    return q * q;
}

}  // namespace flownav::motion
