#pragma once
#include "flownav/io/event_maker.h"
#include "flownav/pipeline/pipeline.h"

namespace flownav::io {

/// Hands a reading of wheels or gyro to the pipeline; ignores fields and ground truth.
void note_reading(pipeline::State& state, const SensorEvent& event);

}  // namespace flownav::io
