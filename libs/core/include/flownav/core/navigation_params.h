#pragma once

#include "flownav/core/robot_model.h"

namespace flownav {

enum class NavigatorKind {
    Lanes,     ///< circular lanes over the local map
    Reactive,  ///< MRPT's CReactiveNavigationSystem
};

/// When ways are planned on the map of everything seen so far.
enum class PlanPolicy {
    Always,  ///< the navigator follows a plan
    Stuck,   ///< it drives straight at the goal, and gets a plan when it is stuck
    Never,   ///< it is on its own
};

/// How to drive, as the ini's section [navigation] has it.
struct NavigationParams {
    NavigatorKind navigator = NavigatorKind::Lanes;
    PlanPolicy plan = PlanPolicy::Always;
    RobotModel robot;
    double controller_period_s = 0.2;  ///< period of the navigator
    double goal_radius_m = 0.3;   ///< arrived when this near
};

}  // namespace flownav
