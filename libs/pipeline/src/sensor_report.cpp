#include "flownav/pipeline/sensor_report.h"

#include <algorithm>

namespace flownav::pipeline {

SensorReport sensor_report(const Step& step, const CameraModel& camera) {
    SensorReport report;
    report.timestamp_s = step.timestamp_s;
    report.status = step.status;
    report.end_of_cycle = step.end_of_cycle;
    report.omega_radps = step.omega_radps;
    report.v_mps = step.v_mps;
    // What other sensors told cannot confirm them.
    report.v_measured = step.v_measured && step.motion.forward_source == MotionSource::Flow;
    report.carried_s = step.carried.since_s;
    for (const BlockRecord& block : step.blocks) {
        const double across = block.vector.at_px.x() / camera.width_px;
        const int sector =
            std::clamp(static_cast<int>(across * SensorReport::sectors), 0, SensorReport::sectors - 1);
        ++report.blocks[sector];
        report.confident[sector] += block.fresh;
    }
    return report;
}

}  // namespace flownav::pipeline
