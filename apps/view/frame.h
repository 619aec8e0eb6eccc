#pragma once
#include <cstddef>
#include <memory>
#include <optional>

#include "flownav/core/field.h"
#include "flownav/pipeline/step.h"

namespace flownav::view {

/// What the last finished cycle found, in the robot frame of its end.
struct CycleResult {
    double timestamp_s = 0.0;
    Pose2 T_start_robot;
    std::vector<ObstaclePoint> obstacles;
    std::vector<GroundPatch> ground;
    VirtualScan scan;
};

/// One field with everything the pipeline knows about it.
struct Frame {
    std::size_t index = 0;  ///< of the fields of the recording, from 0
    Field field;
    std::optional<Field> reference;  ///< what the field was compared with; nothing for a first field
    pipeline::Step step;
    std::shared_ptr<const CycleResult> last_cycle;  ///< null before the first finished cycle
    bool preview = false;  ///< computed from a few fields only: the numbers are about, not exactly, final
};

}  // namespace flownav::view
