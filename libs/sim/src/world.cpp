#include "flownav/sim/world.h"

#include <algorithm>

namespace flownav::sim {

const char* to_string(ThingKind kind) {
    switch (kind) {
        case ThingKind::Wall:
            return "wall";
        case ThingKind::Box:
            return "box";
        case ThingKind::LowBox:
            return "low box";
        case ThingKind::Pole:
            return "pole";
        case ThingKind::Drum:
            return "drum";
        case ThingKind::Chair:
            return "chair";
        case ThingKind::Rail:
            return "rail";
        case ThingKind::Mover:
            return "mover";
    }
    return "";
}

Eigen::Isometry3d pose_at(const Solid& solid, double time_s) {
    const std::vector<TimedPose>& script = solid.script;
    if (script.empty()) return solid.T_world_solid;
    const auto later = std::find_if(script.begin(), script.end(),
                                    [&](const TimedPose& pose) { return pose.time_s > time_s; });
    if (later == script.begin()) return script.front().T_world_solid;
    if (later == script.end()) return script.back().T_world_solid;
    const TimedPose& from = *(later - 1);
    const double share = (time_s - from.time_s) / (later->time_s - from.time_s);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() =
        from.T_world_solid.translation() * (1.0 - share) + later->T_world_solid.translation() * share;
    pose.linear() = Eigen::Quaterniond(from.T_world_solid.linear())
                        .slerp(share, Eigen::Quaterniond(later->T_world_solid.linear()))
                        .toRotationMatrix();
    return pose;
}

}  // namespace flownav::sim
