#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "flownav/flow/block_layout.h"
#include "flownav/testing/grey_image.h"

namespace flownav::bench {

/// The exact displacement of what a place of the reference shows; nothing where that is not known, or not to
/// be seen in the newer image.
using TrueFlow = std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d& at_px)>;

/// Two images of the same size between which the flow is known.
struct FlowPair {
    testing::GreyImage reference, newer;
    flow::BlockLayout layout;
    TrueFlow truth;
};

/// Pairs of the same size and layout. `sequence`: image i is the newer one of pair i - 1 and the reference of
/// pair i.
struct FlowCase {
    std::string name;
    std::vector<FlowPair> pairs;
    bool sequence = false;
};

/// Consecutive fields (768x288) of a robot that drives and turns on carpet past rails, chairs, poles and
/// boxes, with camera noise; 350 blocks where the sensor has them. Nearly all flow is within the search
/// window.
const FlowCase& rendered_case();

/// The Middlebury pairs below a folder of the test data, 350 blocks on a regular grid; empty without them.
/// Throws std::runtime_error naming a damaged file.
std::vector<std::string> middlebury_names();
FlowCase middlebury_case(const std::string& name);

}  // namespace flownav::bench
