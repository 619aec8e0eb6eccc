#pragma once
#include "flownav/core/derotation.h"

namespace flownav::motion {

/// Unknowns of the rotation estimate.
enum class MotionModel {
    Yaw,       ///< yaw only, as in [P]
    YawPitch,  ///< yaw and pitch rate from a line fit of omega_i over x/(a y + b)
};

struct MotionParams {
    Geometry geometry = Geometry::MidPoint;
    MotionModel model = MotionModel::YawPitch;
    double lambda_px = 1.0;  ///< Eq. (11): largest distance of a vector from its line through the FOE
};

}  // namespace flownav::motion
