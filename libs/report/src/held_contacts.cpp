#include "flownav/report/held_contacts.h"

namespace flownav::report {

void HeldContacts::take(const pipeline::Step& step) {
    if (step.new_contacts) {
        scan_ = step.contacts;
    } else if (step.restarted) {
        scan_ = {};
    } else {
        const Pose2 T_now_before = compose(inverse(step.T_start_robot), T_start_robot_);
        scan_.T_robot_scan = compose(T_now_before, scan_.T_robot_scan);
    }
    T_start_robot_ = step.T_start_robot;
}

}  // namespace flownav::report
