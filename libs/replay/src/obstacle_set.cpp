#include "flownav/replay/obstacle_set.h"

namespace flownav::replay {

void copy_surroundings(const pipeline::Step& step, mapping::ObstacleSet& set) {
    set.timestamp_s = step.timestamp_s;
    set.T_map_robot = step.T_start_robot;
    set.points = step.obstacles;
    set.ground = step.ground;
    if (step.new_contacts) {
        set.contacts = step.contacts;
    } else {
        set.contacts.gate = ContactGate::Off;
        set.contacts.strips.clear();
    }
}

}  // namespace flownav::replay
