#pragma once
#include <functional>
#include <string>
#include <vector>

#include "known_flow.h"

namespace flownav::bench {

/// Flow measured at the blocks of a pair, in their order.
struct MeasuredFlow {
    std::vector<Eigen::Vector2d> flow_px;
    std::vector<char> kept;  ///< 1: accepted by the method
};

/// Measures the flow at the centres of the blocks of a pair. Every method starts from zero motion.
using MeasureFlow = std::function<void(const FlowPair& pair, MeasuredFlow& measured)>;

struct FlowMethod {
    std::string name;
    std::function<MeasureFlow()> make;
};

/// All methods. flownav: every kernel with whole pixels, the default kernel with sub-pixel, and the sensor's
/// default. OpenCV: PyrLK, DIS, matchTemplate.
std::vector<FlowMethod> all_methods();

}  // namespace flownav::bench
