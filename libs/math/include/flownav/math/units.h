#pragma once
#include <cmath>

namespace flownav {

/// One degree, in radians: multiply degrees by it, or divide radians by it.
constexpr double degree_rad = M_PI / 180.0;

/// An angle or a turn rate in degrees, from radians.
constexpr double deg(double angle_rad) {
    return angle_rad * 180.0 / M_PI;
}

}  // namespace flownav
