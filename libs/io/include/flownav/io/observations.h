#pragma once
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <string>

#include "flownav/core/field.h"
#include "flownav/io/event_maker.h"
#include "flownav/pipeline/step.h"

namespace flownav::io {

/// FLOW_SCAN: the virtual scan of a finished cycle, horizontal, about the robot's axis on the ground. Only
/// beams that end at an obstacle are valid, whatever the obstacle was found by. A beam of confirmed floor is
/// INVALID with the confirmed range in its range field; a beam without evidence is invalid with range 0. Maps
/// must not take invalid beams for free space (insertionOptions.considerInvalidRangesAsFreeSpace = false):
/// MRPT's default clears them up to half of the preceding valid range or of maxDistanceInsertion, independent
/// of the beam's range and maxRange.
mrpt::obs::CObservation2DRangeScan::Ptr scan_observation(const pipeline::Step& step, double range_max_m);

/// FLOW_POINTS: the obstacle points of a finished cycle in the robot frame, in metres; an empty cloud when
/// there are none.
mrpt::obs::CObservationPointCloud::Ptr points_observation(const pipeline::Step& step);

/// FLOW_ODOMETRY: the integrated pose, identity at the first field, with forward speed and turn rate when the
/// turn was measured or told by other sensors.
mrpt::obs::CObservationOdometry::Ptr odometry_observation(const pipeline::Step& step);

/// FLOW_POSE: the pose of FLOW_ODOMETRY with its covariance, which CObservationOdometry has no room for. z,
/// pitch and roll are 0 and exact.
mrpt::obs::CObservationRobotPose::Ptr pose_observation(const pipeline::Step& step);

/// ODOMETRY: the robot's own odometry, projected on the ground.
mrpt::obs::CObservationOdometry::Ptr odometry_observation(const PoseSample& sample);

/// Image of the field as used: grey, one parity, with the applied calibration and camera pose. Copies the
/// pixels.
mrpt::obs::CObservationImage::Ptr image_observation(const Field& field, const std::string& label);

}  // namespace flownav::io
