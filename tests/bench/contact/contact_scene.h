#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/sim/camera_simulator.h"

namespace flownav::contact_bench {

/// Things of one colour that stand beside the way.
enum class Things { Posts, Boxes, Walls, Mats };

const char* to_string(Things things);

struct SceneOptions {
    Things things = Things::Posts;
    sim::Surface floor = sim::Surface::Carpet;
    double speed_mps = 0.8;
    double turn_radps = 0.3;
    double seconds = 12.0;
    std::uint64_t seed = 1;
};

/// A recorded drive; image i was taken at poses[i].
struct RecordedScene {
    SceneOptions options;
    sim::World world;
    std::vector<Pose2> poses;
    std::vector<Field> fields;
};

/// Places the things, drives a weaving way between them and renders.
RecordedScene record(const SceneOptions& options, const sim::CameraSimParams& camera);

}  // namespace flownav::contact_bench
