#pragma once
#include <mrpt/math/TPose3D.h>

#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "flownav/core/field.h"
#include "flownav/core/readings.h"

namespace flownav::io {

/// Pose of the robot's axis, as recorded.
struct PoseSample {
    enum class Source { Odometry, GroundTruth };
    Source source = Source::Odometry;
    double timestamp_s = 0.0;
    mrpt::math::TPose3D pose;
};

/// A field, a pose, or a reading of a gyro.
using SensorEvent = std::variant<Field, PoseSample, GyroRate>;

/// Counts of observations read, used and rejected.
struct InputCounts {
    std::uint64_t objects = 0;                          ///< objects of a rawlog; 0 for other sources
    std::uint64_t images = 0;                           ///< images with the camera's label
    std::uint64_t fields = 0;                           ///< returned by next()
    std::uint64_t odometry = 0;                         ///< odometry poses used
    std::uint64_t ground_truth = 0;                     ///< ground truth poses used
    std::uint64_t gyro = 0;                             ///< gyro readings used
    std::uint64_t ignored = 0;                          ///< observations of other labels and classes
    std::map<std::string, std::uint64_t> rejected;      ///< by reason, see EventMaker and EventTimes
    std::map<std::string, std::uint64_t> warnings;      ///< used nevertheless: image_size_changed, ...
    std::map<std::string, std::uint64_t> observations;  ///< all observations, by "class label"
    std::map<std::string, double> details;              ///< numbers for the sentences about the counts
};

}  // namespace flownav::io
