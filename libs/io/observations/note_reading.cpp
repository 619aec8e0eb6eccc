#include "flownav/io/note_reading.h"

namespace flownav::io {

void note_reading(pipeline::State& state, const SensorEvent& event) {
    if (const auto* gyro = std::get_if<GyroRate>(&event)) pipeline::note_gyro(state, *gyro);
    const auto* pose = std::get_if<PoseSample>(&event);
    if (pose == nullptr || pose->source != PoseSample::Source::Odometry) return;
    pipeline::note_wheels(state, {pose->timestamp_s, {pose->pose.x, pose->pose.y, pose->pose.yaw}});
}

}  // namespace flownav::io
