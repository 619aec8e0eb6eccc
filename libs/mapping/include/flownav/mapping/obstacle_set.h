#pragma once

#include <vector>

#include "flownav/core/contact_scan.h"
#include "flownav/core/obstacle_point.h"
#include "flownav/core/pose2.h"

namespace flownav::mapping {

/// What one cycle of the sensor saw, and from where.
struct ObstacleSet {
    double timestamp_s = 0.0;
    Pose2 T_map_robot;                  ///< robot pose in the map's frame
    std::vector<ObstaclePoint> points;  ///< robot frame
    std::vector<GroundPatch> ground;    ///< robot frame
    ContactScan contacts = {};          ///< ContactGate::Off: no new scan
};

/// True when the set says nothing about any cell, as those of a robot that stands.
inline bool is_empty(const ObstacleSet& set) {
    return set.points.empty() && set.ground.empty() && set.contacts.gate != ContactGate::Open;
}

}  // namespace flownav::mapping
