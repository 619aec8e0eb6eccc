#include "chain_run.h"

#include "flownav/config/make_state.h"
#include "flownav/io/camera_conversion.h"
#include "flownav/sim/wheel_odometry.h"

namespace flownav::fidelity {
namespace {

CameraModel believed(const CameraModel& camera, const config::CameraConfig& config) {
    mrpt::obs::CObservationImage recorded;
    recorded.cameraParams = io::camera_params(camera);
    recorded.cameraPose = io::camera_pose(camera.mount);
    return io::read_camera(recorded, config, camera.width_px, camera.height_px).camera;
}

/// A reading of the wheels at each image; none for a drive without wheels.
std::vector<WheelPose> wheels_of(const RenderedScene& drive) {
    sim::WheelOdometry odometry(sim::OdometryParams{});
    std::vector<WheelPose> readings;
    if (!drive.wheels) return readings;
    for (std::size_t i = 0; i < drive.fields.size(); ++i)
        readings.push_back({drive.fields[i].timestamp_s, odometry.update(drive.scene.poses[i])});
    return readings;
}

}  // namespace

void run_chain(const RenderedScene& drive, const config::Config& config, const Watcher& watcher) {
    pipeline::State state = config::make_state(config);
    const std::vector<WheelPose> wheels = wheels_of(drive);
    int reference = 0;
    for (int i = 0; i < static_cast<int>(drive.fields.size()); ++i) {
        Field field = drive.fields[static_cast<std::size_t>(i)];
        field.camera = believed(field.camera, config.camera);
        if (drive.wheels) pipeline::note_wheels(state, wheels[static_cast<std::size_t>(i)]);
        const pipeline::Step& step = pipeline::step(state, field);
        if (step.status == FieldStatus::Waiting) reference = i;
        watcher({drive, config, step, i, reference});
        if (step.end_of_cycle) reference = i;
    }
}

}  // namespace flownav::fidelity
