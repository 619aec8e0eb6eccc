#pragma once
#include <mrpt/obs/CObservation.h>

#include "flownav/core/camera_model.h"
#include "flownav/pipeline/step.h"

namespace flownav {

/// FLOW_FIELD: the whole record of one field and its camera. Programs that do not know this class stop
/// reading a rawlog at it, so it is kept in separate files; MRPT's tools read it with the plug-in. All
/// versions of the serialization can be read.
class CObservationFlowField : public mrpt::obs::CObservation {
    DEFINE_SERIALIZABLE(CObservationFlowField, flownav)

  public:
    CObservationFlowField() = default;

    pipeline::Step step;
    CameraModel camera;  ///< also holds the size of the image

    /// Pose of the camera on the robot, optical axes (x right, y down, z forward).
    void getSensorPose(mrpt::poses::CPose3D& pose) const override;
    void setSensorPose(const mrpt::poses::CPose3D& pose) override;

    void getDescriptionAsText(std::ostream& out) const override;

    /// Text export as numbers separated by blanks: the columns of the field, among them the numbers of blocks
    /// and obstacle points, then the blocks and the points, then the sources of the motion, the gate and fit
    /// of a new contact scan, and its strips. Enums are written as numbers that the header explains.
    bool exportTxtSupported() const override { return true; }
    std::string exportTxtHeader() const override;
    std::string exportTxtDataRow() const override;
};

/// Makes the observation of a field, with the time stamp of the step.
CObservationFlowField::Ptr flow_field_observation(const pipeline::Step& step, const CameraModel& camera);

}  // namespace flownav
