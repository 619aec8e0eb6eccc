#include "flownav/nav/guard_reason.h"

#include <algorithm>
#include <array>

namespace flownav::nav {
namespace {

/// From harmless to grave.
constexpr std::array<GuardReason, 10> by_gravity = {
    GuardReason::None,           GuardReason::UnseenAhead,           GuardReason::UnconfirmedAhead,
    GuardReason::ObstacleAhead,  GuardReason::OdometryContradiction, GuardReason::SensorFrozen,
    GuardReason::OmegaLost,      GuardReason::SensorBlind,           GuardReason::SensorStale,
    GuardReason::NavigatorSilent};

}  // namespace

int gravity(GuardAction action) {
    switch (action) {
        case GuardAction::Pass:
            return 0;
        case GuardAction::Slow:
            return 1;
        case GuardAction::Stop:
            return 2;
    }
    return 2;
}

int gravity(GuardReason reason) {
    return static_cast<int>(std::find(by_gravity.begin(), by_gravity.end(), reason) - by_gravity.begin());
}

bool is_fault_of_sensing(GuardReason reason) {
    switch (reason) {
        case GuardReason::OdometryContradiction:
        case GuardReason::SensorFrozen:
        case GuardReason::OmegaLost:
        case GuardReason::SensorBlind:
        case GuardReason::SensorStale:
            return true;
        case GuardReason::None:
        case GuardReason::UnseenAhead:
        case GuardReason::UnconfirmedAhead:
        case GuardReason::ObstacleAhead:
        case GuardReason::NavigatorSilent:
            return false;
    }
    return true;
}

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
        case GuardReason::UnconfirmedAhead:
            return "unconfirmed_ahead";
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
