#pragma once
#include "state.h"

namespace flownav::pipeline {

/// Decides for every block of the running cycle whether it saw ground, an obstacle or nothing of use.
void judge_blocks(State::Impl& s);

/// At the end of a cycle: 3D points, confirmed floor and the virtual scan, in the robot frame of now.
void publish_obstacles(State::Impl& s);

}  // namespace flownav::pipeline
