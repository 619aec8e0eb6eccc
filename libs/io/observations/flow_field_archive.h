#pragma once
#include <mrpt/serialization/CArchive.h>

#include "flownav/core/camera_model.h"
#include "flownav/pipeline/step.h"

namespace flownav {

/// Serialization of CObservationFlowField. Writes version 2. Version 1 added the widths of the patches of
/// floor, version 2 the contact scan, causes and intervals of the beams and the sources of the motion.
/// Reading throws std::runtime_error on invalid numbers and never allocates more than the archive delivers.
void write_camera(mrpt::serialization::CArchive& out, const CameraModel& camera);
CameraModel read_camera(mrpt::serialization::CArchive& in);
void write_step(mrpt::serialization::CArchive& out, const pipeline::Step& step);
pipeline::Step read_step(mrpt::serialization::CArchive& in, int version);

}  // namespace flownav
