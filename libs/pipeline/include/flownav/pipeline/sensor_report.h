#pragma once

#include "flownav/core/camera_model.h"
#include "flownav/core/sensor_report.h"
#include "flownav/pipeline/step.h"

namespace flownav::pipeline {

/// What the record of one field, taken by `camera`, says about the sensor itself.
SensorReport sensor_report(const Step& step, const CameraModel& camera);

}  // namespace flownav::pipeline
