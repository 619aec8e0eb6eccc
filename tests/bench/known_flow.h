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

/// Exact displacement of a place of the reference; empty when it is unknown, or not visible in the newer
/// image.
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
/// boxes, with camera noise; 350 blocks at the sensor's places. Nearly all flow is within the search window.
const FlowCase& rendered_case();

/// Names of the Middlebury pairs in the test data, 350 blocks on a regular grid each; empty when they are
/// missing. Throws std::runtime_error naming a damaged file.
std::vector<std::string> middlebury_names();
FlowCase middlebury_case(const std::string& name);

}  // namespace flownav::bench
