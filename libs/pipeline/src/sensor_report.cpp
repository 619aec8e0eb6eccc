#include "flownav/pipeline/sensor_report.h"

#include <algorithm>
#include <cmath>

namespace flownav::pipeline {
namespace {

// A scan from farther away does not speak of what is in view now.
constexpr double scan_way_m = 0.3;
constexpr double scan_turn_rad = 0.3;

int sector_of(double share_across) {
    if (!(share_across >= 0.0 && share_across <= 1.0)) return 0;
    return std::clamp(static_cast<int>(share_across * SensorReport::sectors), 0, SensorReport::sectors - 1);
}

bool speaks_of_now(const ContactScan& scan) {
    const Pose2& T = scan.T_robot_scan;
    return scan.gate == ContactGate::Open && std::hypot(T.x_m, T.y_m) < scan_way_m &&
           std::abs(T.yaw_rad) < scan_turn_rad;
}

void count_strips(const ContactScan& scan, const CameraModel& camera, SensorReport& report) {
    if (!speaks_of_now(scan)) return;
    const double per_tangent = camera.fx_px * std::cos(camera.mount.pitch_rad);
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        const double across = (camera.cx_px + per_tangent * middle_tangent(scan, i)) / camera.width_px;
        if (!(across >= 0.0 && across <= 1.0)) continue;
        ++report.bearings[sector_of(across)];
        report.decided[sector_of(across)] +=
            scan.strips[static_cast<std::size_t>(i)].kind != BeamKind::Unknown;
    }
}

}  // namespace

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
        const int sector = sector_of(block.vector.at_px.x() / camera.width_px);
        ++report.blocks[sector];
        report.confident[sector] += block.fresh;
    }
    count_strips(step.contacts, camera, report);
    return report;
}

}  // namespace flownav::pipeline
