#pragma once

#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/nav/navigation_stack.h"
#include "flownav/nav/robot_base.h"
#include "flownav/pipeline/repeated_images.h"
#include "flownav/pipeline/step.h"

namespace flownav::drive {

/// Source of a robot's sensor updates; implemented by a camera thread, the simulation or a test.
class SensorFeed {
  public:
    SensorFeed() = default;
    virtual ~SensorFeed() = default;
    SensorFeed(const SensorFeed&) = delete;
    SensorFeed& operator=(const SensorFeed&) = delete;

    /// Takes a reading of the wheels, for the sensor's own use. Called before arrived(); never waits.
    virtual void odometry(const nav::WheelReading& /*reading*/) {}

    /// Returns the updates that arrived since the last call, in order of arrival. Never waits.
    virtual std::vector<nav::SensorUpdate> arrived() = 0;

    /// Returns the reason why no more updates will come; empty while more may come.
    virtual std::string end() = 0;
};

/// Converts the record of a field to an update for the navigation stack; times are reduced by `epoch_s`.
/// `images` is updated with every field.
nav::SensorUpdate sensor_update_of(const pipeline::Step& step, const Field& field,
                                   pipeline::RepeatedImages& images, double epoch_s = 0.0);

}  // namespace flownav::drive
