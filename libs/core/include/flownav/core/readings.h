#pragma once
#include "flownav/core/pose2.h"

namespace flownav {

/// One reading of the robot's wheels. Its time is in the clock that stamps the camera's fields.
struct WheelPose {
    double timestamp_s = 0.0;
    Pose2 T_odom_robot;  ///< since an arbitrary start
};

/// One reading of a gyro about the robot's upward axis. Its time is in the clock that stamps the camera's
/// fields.
struct GyroRate {
    double timestamp_s = 0.0;
    double omega_radps = 0.0;  ///< > 0 to the left
};

}  // namespace flownav
