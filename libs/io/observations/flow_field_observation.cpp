#include "flownav/io/flow_field_observation.h"

#include <mrpt/core/Clock.h>
#include <mrpt/serialization/CArchive.h>

#include "flow_field_archive.h"
#include "flownav/io/camera_conversion.h"

IMPLEMENTS_SERIALIZABLE(CObservationFlowField, CObservation, flownav)

namespace flownav {

void CObservationFlowField::getSensorPose(mrpt::poses::CPose3D& pose) const {
    pose = io::camera_pose(camera.mount);
}

void CObservationFlowField::setSensorPose(const mrpt::poses::CPose3D& pose) {
    camera.mount = io::camera_mount(pose);
}

std::uint8_t CObservationFlowField::serializeGetVersion() const {
    return 2;
}

void CObservationFlowField::serializeTo(mrpt::serialization::CArchive& out) const {
    out << timestamp << sensorLabel;
    write_camera(out, camera);
    write_step(out, step);
}

void CObservationFlowField::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version) {
    switch (version) {
        case 0:
        case 1:
        case 2:
            in >> timestamp >> sensorLabel;
            camera = read_camera(in);
            step = read_step(in, version);
            break;
        default:
            MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
    }
}

CObservationFlowField::Ptr flow_field_observation(const pipeline::Step& step, const CameraModel& camera) {
    auto observation = CObservationFlowField::Create();
    observation->timestamp = mrpt::Clock::fromDouble(step.timestamp_s);
    observation->sensorLabel = "FLOW_FIELD";
    observation->step = step;
    observation->camera = camera;
    return observation;
}

}  // namespace flownav
