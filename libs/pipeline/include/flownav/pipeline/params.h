#pragma once
#include "flownav/flow/params.h"
#include "flownav/motion/params.h"
#include "flownav/obstacles/params.h"

namespace flownav::pipeline {

struct RateParams {
    int cycle_images = 0;    ///< r: images compared with one reference; 0: chosen from the speed ("auto")
    double travel_m = 0.08;  ///< travel per cycle that "auto" aims at
    double gap_max_s = 0.5;  ///< a longer pause between fields starts a new chain
    /// For so long after it was measured last, the motion is carried over; then the robot counts as standing,
    /// with an error that grows as if it went on.
    double carry_max_s = 1.0;
};

/// What another sensor of motion is used for. Without readings each of them is off.
enum class SensorUse {
    Off,
    Fallback,  ///< tells the motion that the flow does not measure
    Prior,     ///< in addition tells where to look for the flow, and is averaged with it
};

struct OtherSensorParams {
    SensorUse wheels = SensorUse::Fallback;  ///< readings of note_wheels()
    SensorUse gyro = SensorUse::Fallback;    ///< readings of note_gyro()
};

struct Params {
    flow::FlowParams flow;
    motion::MotionParams motion;
    obstacles::ObstacleParams obstacles;
    RateParams rate;
    OtherSensorParams other_sensors;
    bool pitch_online = false;  ///< learn the camera's true pitch while driving
    int threads = 1;            ///< of the block matching; the result does not depend on it
};

}  // namespace flownav::pipeline
