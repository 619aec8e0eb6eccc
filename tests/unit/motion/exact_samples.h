#pragma once
#include <vector>

#include "flownav/motion/estimate_motion.h"
#include "flownav/sim/random.h"
#include "flownav/testing/truth.h"

namespace flownav::testing {

constexpr double image_s = 1.0 / 25.0;

/// Two views of a world, and the exact motion of the robot between them.
struct Pair {
    World world;
    View from;
    View to;
    EgoMotion truth;
};

/// A robot that drives and turns during `images` images at 25 Hz.
Pair drive(const CameraModel& camera, double v_mps, double omega_degps, double images,
           const World& world = {}, const Pose2& start = {});

/// Exact flow at the places of the sensor's blocks.
std::vector<FlowVector> exact_vectors(const Pair& pair);

/// Converts vectors to the input of the ego-motion.
std::vector<motion::MotionSample> samples_of(const Pair& pair, const std::vector<FlowVector>& vectors,
                                             Geometry geometry = Geometry::MidPoint);

inline std::vector<motion::MotionSample> exact_samples(const Pair& pair,
                                                       Geometry geometry = Geometry::MidPoint) {
    return samples_of(pair, exact_vectors(pair), geometry);
}

/// Runs estimate_motion() with the camera of the pair and a rough prediction, as from the previous cycle.
motion::MotionEstimate estimate(const Pair& pair, const std::vector<motion::MotionSample>& samples,
                                const motion::MotionParams& params = {});

}  // namespace flownav::testing
