#include "flownav/pipeline/sensor_report.h"

#include <algorithm>

namespace flownav::pipeline {
namespace {

constexpr int sparse_px = 16;  // spacing of the pixels that tell the brightness of a sector
constexpr double black_grey = 24.0;
constexpr double saturated_grey = 250.0;

int sector_of(double share_across) {
    if (!(share_across >= 0.0 && share_across <= 1.0)) return 0;
    return std::clamp(static_cast<int>(share_across * SensorReport::sectors), 0, SensorReport::sectors - 1);
}

/// True when the last scan shows that the camera sees something, or none could be made yet.
bool sees_edges(const ContactScan& scan) {
    if (scan.gate == ContactGate::NoTravel) return true;
    return scan.gate == ContactGate::Open &&
           std::any_of(scan.strips.begin(), scan.strips.end(), [](const ContactStrip& s) { return s.seen; });
}

}  // namespace

std::array<bool, SensorReport::sectors> unlit_sectors(const ImageView& image) {
    std::array<bool, SensorReport::sectors> unlit = {};
    if (image.width_px < SensorReport::sectors || image.height_px <= 0) return unlit;
    for (int sector = 0; sector < SensorReport::sectors; ++sector) {
        const int begin = sector * image.width_px / SensorReport::sectors;
        const int end = (sector + 1) * image.width_px / SensorReport::sectors;
        int sum = 0;
        int pixels = 0;
        for (int v = 0; v < image.height_px; v += sparse_px) {
            for (int u = begin; u < end; u += sparse_px) {
                sum += image.at(u, v);
                ++pixels;
            }
        }
        const double mean = static_cast<double>(sum) / pixels;
        unlit[static_cast<std::size_t>(sector)] = mean < black_grey || mean > saturated_grey;
    }
    return unlit;
}

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
    report.scans = step.contacts.gate != ContactGate::Off;
    report.sees_edges = sees_edges(step.contacts);
    return report;
}

}  // namespace flownav::pipeline
