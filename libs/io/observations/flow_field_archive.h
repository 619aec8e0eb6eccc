#pragma once
#include <mrpt/serialization/CArchive.h>

#include "flownav/core/camera_model.h"
#include "flownav/pipeline/step.h"

namespace flownav {

/// Serialization of CObservationFlowField. Writes version 1, which adds the widths of the patches of floor to
/// version 0. Reading throws std::runtime_error on invalid numbers and never allocates more than the archive
/// delivers.
void write_camera(mrpt::serialization::CArchive& out, const CameraModel& camera);
CameraModel read_camera(mrpt::serialization::CArchive& in);
void write_step(mrpt::serialization::CArchive& out, const pipeline::Step& step);
pipeline::Step read_step(mrpt::serialization::CArchive& in, int version);

/// Number of a value in files, independent of its position in the enum.
int stored_number(FieldStatus status);
int stored_number(BlockLabel label);

/// Legend of the stored numbers, such as "0 = ok, 1 = waiting, ...".
std::string stored_statuses();
std::string stored_labels();

}  // namespace flownav
