#pragma once
#include <mrpt/obs/CObservation.h>

#include "flownav/core/camera_model.h"
#include "flownav/pipeline/step.h"

namespace flownav {

/// FLOW_FIELD: the whole record of one field and the camera that took it. A class of this project: programs
/// that do not know it stop reading a rawlog at the first one, so it belongs into files of its own; MRPT's
/// tools read it with the plug-in. Serialized in versions; every version ever written can be read.
class CObservationFlowField : public mrpt::obs::CObservation {
    DEFINE_SERIALIZABLE(CObservationFlowField, flownav)

  public:
    CObservationFlowField() = default;

    pipeline::Step step;
    CameraModel camera;  ///< also the size of the image

    /// Camera on the robot, optical axes (x right, y down, z forward).
    void getSensorPose(mrpt::poses::CPose3D& pose) const override;
    void setSensorPose(const mrpt::poses::CPose3D& pose) override;

    void getDescriptionAsText(std::ostream& out) const override;

    /// Columns of numbers separated by blanks: those of the field, then as many blocks and obstacle points as
    /// the row says. Words are written as numbers that the header explains.
    bool exportTxtSupported() const override { return true; }
    std::string exportTxtHeader() const override;
    std::string exportTxtDataRow() const override;
};

/// The observation of a field, with the time of its record.
CObservationFlowField::Ptr flow_field_observation(const pipeline::Step& step, const CameraModel& camera);

}  // namespace flownav
