#pragma once

#include "flownav/core/camera_model.h"
#include "flownav/core/image_view.h"
#include "flownav/core/sensor_report.h"
#include "flownav/pipeline/step.h"

namespace flownav::pipeline {

/// What the record of one field, taken by `camera`, says about the sensor itself.
SensorReport sensor_report(const Step& step, const CameraModel& camera);

/// The sectors of an image that are black or saturated in the mean, as behind a cover.
std::array<bool, SensorReport::sectors> unlit_sectors(const ImageView& image);

}  // namespace flownav::pipeline
