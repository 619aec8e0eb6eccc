#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace flownav::fidelity {

constexpr double nothing_measured = std::numeric_limits<double>::quiet_NaN();

/// Mean and spread of errors; can be added over several drives.
struct Moments {
    std::int64_t count = 0;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    double sum_of_magnitudes = 0.0;

    void add(double value) {
        ++count;
        sum += value;
        sum_of_squares += value * value;
        sum_of_magnitudes += std::abs(value);
    }
    void add(const Moments& other) {
        count += other.count;
        sum += other.sum;
        sum_of_squares += other.sum_of_squares;
        sum_of_magnitudes += other.sum_of_magnitudes;
    }
    double mean() const { return count > 0 ? sum / static_cast<double>(count) : nothing_measured; }
    double mean_magnitude() const {
        return count > 0 ? sum_of_magnitudes / static_cast<double>(count) : nothing_measured;
    }
    double rms() const {
        return count > 0 ? std::sqrt(sum_of_squares / static_cast<double>(count)) : nothing_measured;
    }
    double deviation() const {
        const double mean_value = mean();
        return count > 0 ? std::sqrt(std::max(0.0, rms() * rms() - mean_value * mean_value))
                         : nothing_measured;
    }
};

/// A number of hits out of a total.
struct Share {
    std::int64_t hits = 0;
    std::int64_t all = 0;

    void add(bool hit) {
        hits += hit ? 1 : 0;
        ++all;
    }
    void add(const Share& other) {
        hits += other.hits;
        all += other.all;
    }
    double percent() const {
        return all > 0 ? 100.0 * static_cast<double>(hits) / static_cast<double>(all) : nothing_measured;
    }
    /// Hits per element of `all`, such as false alarms per cycle.
    double rate() const { return 0.01 * percent(); }
};

inline double median(std::vector<double> values) {
    if (values.empty()) return nothing_measured;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace flownav::fidelity
