#include "flownav/nav/guard_reason.h"

namespace flownav::nav {

const char* to_string(GuardAction action) {
    switch (action) {
        case GuardAction::Pass:
            return "pass";
        case GuardAction::Slow:
            return "slow";
        case GuardAction::Stop:
            return "stop";
    }
    return "unknown";
}

const char* to_string(GuardReason reason) {
    switch (reason) {
        case GuardReason::None:
            return "none";
        case GuardReason::UnseenAhead:
            return "unseen_ahead";
        case GuardReason::ObstacleAhead:
            return "obstacle_ahead";
        case GuardReason::OdometryContradiction:
            return "odometry_contradiction";
        case GuardReason::SensorFrozen:
            return "sensor_frozen";
        case GuardReason::OmegaLost:
            return "omega_lost";
        case GuardReason::SensorBlind:
            return "sensor_blind";
        case GuardReason::SensorStale:
            return "sensor_stale";
        case GuardReason::NavigatorSilent:
            return "navigator_silent";
    }
    return "unknown";
}

}  // namespace flownav::nav
