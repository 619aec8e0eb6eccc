#pragma once

#include "flownav/mapping/obstacle_set.h"
#include "flownav/pipeline/step.h"

namespace flownav::replay {

/// True when a record has something for a map: a cycle ended, or a contact scan is new.
inline bool is_new_for_map(const pipeline::Step& step) {
    return step.end_of_cycle || step.new_contacts;
}

/// Overwrites `set` by what a record saw, at the pose of the flow odometry. Reuses the memory of `set`.
void copy_surroundings(const pipeline::Step& step, mapping::ObstacleSet& set);

}  // namespace flownav::replay
