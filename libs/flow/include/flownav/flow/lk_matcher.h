#pragma once
#include "flownav/flow/matcher.h"

namespace flownav::flow {

/// Settings of LkMatcher; the defaults did best on the scenes of tests/support. The window size is odd, so
/// that samples lie half-way between pixels, as block centres do, and average four pixels.
struct LkSettings {
    int window_px = 21;                ///< edge of the tracked square
    int levels = 1;                    ///< pyramid levels above the image itself
    double eigenvalue_min = 1e-4;      ///< OpenCV's minEigThreshold
    double disagreement_max_px = 0.5;  ///< forward-backward error at which the confidence reaches 0
    BrightnessModel brightness = BrightnessModel::Image;
};

/// OpenCV's pyramidal Lucas-Kanade with forward-backward check, starting from the predicted flow; a reference
/// for the block matcher. `valid` where a BlockMatcher has a window and the block ends inside the image.
/// confidence = 1 - disagreement / disagreement_max_px, and 0 where the texture is too weak. Results do not
/// depend on OpenCV's number of threads, but may depend on its version. Allocates in every call.
class LkMatcher {
  public:
    explicit LkMatcher(const LkSettings& settings = {}) : settings_(settings) {}

    void operator()(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                    const std::vector<Eigen::Vector2d>& predicted_px, std::vector<FlowVector>& vectors) const;

  private:
    LkSettings settings_;
};

/// Registers LkMatcher as "lk", with `brightness` of FlowParams. Further calls have no effect.
void register_lk_matcher();

}  // namespace flownav::flow
