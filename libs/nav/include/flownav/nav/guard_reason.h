#pragma once

#include <string>

namespace flownav::nav {

/// What the guard does with a command.
enum class GuardAction { Pass, Slow, Stop };

/// Why it does not pass.
enum class GuardReason {
    None,
    UnseenAhead,            ///< ground on the way has not been seen
    UnconfirmedAhead,       ///< ground in view of the contact scan was not confirmed as floor
    ObstacleAhead,          ///< something stands on the way
    OdometryContradiction,  ///< wheels and flow disagree, or the wheels' pose jumped or stopped coming
    SensorFrozen,           ///< the same image again and again while the wheels turn
    OmegaLost,              ///< vectors there are, but no common motion explains them
    SensorBlind,            ///< too few vectors, in the whole image or in a part of it
    SensorStale,            ///< fields or maps do not come, or come late
    NavigatorSilent,        ///< no proposal
};

/// How grave an action or a reason is; the guard logs a change to something graver at once.
int gravity(GuardAction action);
int gravity(GuardReason reason);

/// True when what the robot knows of its surroundings or of its own motion cannot be relied on: a navigator
/// must not plan with it.
bool is_fault_of_sensing(GuardReason reason);

/// The words of logs.
const char* to_string(GuardAction action);
const char* to_string(GuardReason reason);

/// Something that is wrong with what the guard relies on.
struct Fault {
    GuardReason reason = GuardReason::None;  ///< None: nothing is wrong
    std::string why;

    explicit operator bool() const { return reason != GuardReason::None; }
};

}  // namespace flownav::nav
