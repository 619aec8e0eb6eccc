#pragma once
#include <mrpt/serialization/CArchive.h>

#include "flownav/pipeline/step.h"

namespace flownav {

/// Serialization of what version 2 of CObservationFlowField adds: sources of the motion, causes and intervals
/// of the beams, and the contact scan when it is new with the field. Reading fills a step whose motion and
/// beams have been read, and throws std::runtime_error on invalid numbers.
void write_contact_part(mrpt::serialization::CArchive& out, const pipeline::Step& step);
void read_contact_part(mrpt::serialization::CArchive& in, pipeline::Step& step);

/// Fills the same values of a step of an older version: what was measured came from the flow, every obstacle
/// from blocks, and its interval is its range.
void complete_older_step(pipeline::Step& step);

}  // namespace flownav
