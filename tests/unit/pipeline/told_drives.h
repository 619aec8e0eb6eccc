#pragma once
#include <vector>

#include "drives.h"

/// Drives of a robot that has wheels and a gyro besides its camera.
namespace flownav::testing {

/// What wheels and gyro of a robot tell; without errors unless set otherwise.
struct RobotSensors {
    bool wheels = false;
    bool gyro = false;
    double way_scale = 1.0;   ///< told by the wheels over true
    double turn_scale = 1.0;  ///< told by wheels and gyro over true
    double gyro_bias_radps = 0.0;
    double clock_s = 0.0;          ///< added to the time of each reading
    std::size_t wheels_first = 0;  ///< the wheels tell nothing before this image
};

/// Images of noise about one grey value: no block of them can be matched.
Field without_texture(const Field& like, unsigned seed);

/// Runs fields that were taken at `poses` through a pipeline; before each field it gets the readings up to
/// the next one.
std::vector<pipeline::Step> run(const std::vector<Field>& fields, const std::vector<Pose2>& poses,
                                const RobotSensors& sensors, const pipeline::Params& params = {});

/// The same with the pipeline of the caller.
std::vector<pipeline::Step> run(pipeline::State& state, const std::vector<Field>& fields,
                                const std::vector<Pose2>& poses, const RobotSensors& sensors);

}  // namespace flownav::testing
