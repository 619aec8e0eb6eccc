#pragma once
#include <vector>

namespace flownav {

enum class BeamKind {
    Unknown,   ///< this bearing was not seen: NOT free
    Free,      ///< floor was confirmed up to range_m; beyond it is unknown
    Obstacle,  ///< the nearest obstacle stands at range_m
};

struct Beam {
    BeamKind kind = BeamKind::Unknown;
    double range_m = 0.0;
};

/// A horizontal scan about the robot's axis. Beam i covers the bearings
/// first_bearing_rad + i * step_rad +- step_rad / 2 (> 0 to the left).
struct VirtualScan {
    double first_bearing_rad = 0.0;
    double step_rad = 0.0;
    std::vector<Beam> beams;
};

}  // namespace flownav
