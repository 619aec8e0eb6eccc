#pragma once

#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/nav/navigation_stack.h"
#include "flownav/pipeline/repeated_images.h"
#include "flownav/pipeline/step.h"

namespace flownav::drive {

/// What the sensor of a robot has to say; filled by a camera's thread, by the simulation, or by a test.
class SensorFeed {
  public:
    SensorFeed() = default;
    virtual ~SensorFeed() = default;
    SensorFeed(const SensorFeed&) = delete;
    SensorFeed& operator=(const SensorFeed&) = delete;

    /// Everything that arrived since the last call, in its order. Never waits.
    virtual std::vector<nav::SensorUpdate> arrived() = 0;

    /// Why nothing will ever arrive again; empty: more may come.
    virtual std::string end() = 0;
};

/// What a field's record says, for the navigation stack; times less `epoch_s`. `images`: fed with every
/// field.
nav::SensorUpdate sensor_update_of(const pipeline::Step& step, const Field& field,
                                   pipeline::RepeatedImages& images, double epoch_s = 0.0);

}  // namespace flownav::drive
