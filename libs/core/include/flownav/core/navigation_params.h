#pragma once
#include <string>

#include "flownav/core/robot_model.h"

namespace flownav {

/// The robot and how it drives; from the section [navigation] of the ini.
struct NavigationParams {
    std::string navigator = "lanes";  ///< name of a registered navigator
    RobotModel robot;
    double controller_period_s = 0.2;  ///< period of the navigator
};

}  // namespace flownav
