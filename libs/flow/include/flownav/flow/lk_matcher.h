#pragma once
#include "flownav/flow/matcher.h"

namespace flownav::flow {

/// The defaults are those that did best on the scenes of tests/support. The window is odd: its samples then
/// lie half-way between the pixels, as the centres of the blocks do, and being means of four are calmer.
struct LkSettings {
    int window_px = 21;                ///< edge of the square that is followed
    int levels = 1;                    ///< of the pyramid above the image itself
    double eigenvalue_min = 1e-4;      ///< OpenCV's minEigThreshold
    double disagreement_max_px = 0.5;  ///< between the way there and back; where confidence reaches 0
    BrightnessModel brightness = BrightnessModel::Image;
};

/// OpenCV's pyramidal Lucas-Kanade, from the predicted flow and back again, to compare the block matcher
/// with. `valid` where a BlockMatcher has a window and the block ends inside the image. confidence = 1 -
/// disagreement / disagreement_max_px; 0 where the texture is too weak. The results do not depend on
/// OpenCV's number of threads, but may on its version. Allocates in every call.
class LkMatcher {
  public:
    explicit LkMatcher(const LkSettings& settings = {}) : settings_(settings) {}

    void operator()(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                    const std::vector<Eigen::Vector2d>& predicted_px, std::vector<FlowVector>& vectors) const;

  private:
    LkSettings settings_;
};

}  // namespace flownav::flow
