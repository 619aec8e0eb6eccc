#pragma once
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <string>

#include "flownav/core/field.h"
#include "flownav/io/event_maker.h"
#include "flownav/pipeline/step.h"

namespace flownav::io {

/// FLOW_SCAN: the virtual scan of a finished cycle, horizontal, about the robot's axis on the ground. Only a
/// beam that ends at an obstacle is valid. A bearing whose floor was confirmed is INVALID with the confirmed
/// range in its range field, one without evidence is invalid with range 0: maps must not take invalid beams
/// for free space (insertionOptions.considerInvalidRangesAsFreeSpace = false). MRPT's default does, as far as
/// half of the valid range before it or of maxDistanceInsertion, whatever the beam or maxRange say.
mrpt::obs::CObservation2DRangeScan::Ptr scan_observation(const pipeline::Step& step, double range_max_m);

/// FLOW_POINTS: the obstacle points of a finished cycle, robot frame; an empty cloud when there are none.
mrpt::obs::CObservationPointCloud::Ptr points_observation(const pipeline::Step& step);

/// FLOW_ODOMETRY: the integrated pose, identity at the first field, with forward speed and turn rate where
/// this field measured its motion.
mrpt::obs::CObservationOdometry::Ptr odometry_observation(const pipeline::Step& step);

/// ODOMETRY: a copy of the robot's own, projected on the ground.
mrpt::obs::CObservationOdometry::Ptr odometry_observation(const PoseSample& sample);

/// The field as it was used: grey, one parity, with the calibration and camera pose that were used. The
/// pixels are copied.
mrpt::obs::CObservationImage::Ptr image_observation(const Field& field, const std::string& label);

}  // namespace flownav::io
