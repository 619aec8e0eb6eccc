#pragma once
#include <cstddef>
#include <memory>
#include <optional>

#include "flownav/core/field.h"
#include "flownav/pipeline/step.h"
#include "flownav/report/held_contacts.h"

namespace flownav::view {

/// Results of the last finished cycle, in the robot frame at its end.
struct CycleResult {
    double timestamp_s = 0.0;
    Pose2 T_start_robot;
    std::vector<ObstaclePoint> obstacles;
    std::vector<GroundPatch> ground;
    VirtualScan scan;
};

/// One field with its record of the pipeline.
struct Frame {
    std::size_t index = 0;  ///< index of the field in the recording, from 0
    Field field;
    std::optional<Field> reference;  ///< the field it was compared with; empty for a first field
    pipeline::Step step;
    std::shared_ptr<const CycleResult> last_cycle;  ///< null before the first finished cycle
    report::HeldContacts contacts;                  ///< the newest contact scan
    bool preview = false;  ///< computed from a few fields only: the numbers are approximate
};

}  // namespace flownav::view
