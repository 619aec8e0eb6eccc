#pragma once

#include <cstdint>
#include <optional>

#include "flownav/sim/world.h"

namespace flownav::sim {

enum class AheadThing : std::uint8_t {
    None,        ///< free floor
    Post,        ///< a cylinder of `width_m`
    Box,         ///< a cube-like box of `width_m` and `height_m`
    DoorEdge,    ///< the end of a wall that stands across on the left of the path, 2 m long
    WallAcross,  ///< a blank wall across the way, 6 m long
    StepDown,    ///< stairs down across the way, 4 m wide, two steps of 0.17 m and a landing
    KerbUp,      ///< a kerb across the way, 4 m wide and `height_m` high
};

/// One thing on the way of a robot that drives straight ahead from the origin along x.
struct StraightScene {
    AheadThing thing = AheadThing::Post;
    double distance_m = 4.0;  ///< from the origin to the near side of the thing, along x
    double offset_m = 0.0;    ///< of its middle, or of a wall's end, to the left of the path
    double width_m = 0.15;
    double height_m = 0.5;  ///< of posts, boxes, kerbs; walls are 2.2 m high
    Look look{Surface::Plain, 140.0, 0};
    Look floor{Surface::Carpet, 128.0, 1};
    double side_walls_m = 0.0;  ///< > 0: plain walls on both sides at this distance from the path
    bool marks = false;         ///< tape across and along the way, paper and a one-colour mat
    std::optional<ShadowLight> shadow_light;
};

/// The world of a scene: start at the origin, goal 2 m beyond the thing. Throws std::invalid_argument when a
/// length is out of range.
World straight_scene(const StraightScene& scene);

}  // namespace flownav::sim
