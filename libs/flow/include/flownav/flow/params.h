#pragma once

namespace flownav::flow {

/// Refinement of the integer minimum of the SAD surface.
enum class Subpixel {
    None,      ///< integer vectors, as printed in [P]
    V,         ///< equiangular: two lines of opposite slope through the three costs around the minimum
    Parabola,  ///< a parabola through the same three
};

/// What is done about exposure that changes from image to image.
enum class BrightnessModel {
    Constant,  ///< nothing, as [P]
    Image,     ///< one gain and one offset an image
};

/// Who measures the vectors.
enum class MatcherKind {
    Sad,  ///< exhaustive block matching
    Lk,   ///< pyramidal Lucas-Kanade, for comparison; needs OpenCV and is not part of this library
};

struct FlowParams {
    MatcherKind matcher = MatcherKind::Sad;
    int blocks = 350;  ///< how many 16x16 blocks are placed; 16..2000
    Subpixel subpixel = Subpixel::V;
    BrightnessModel brightness = BrightnessModel::Image;
    double confidence_min = 0.06;   ///< a match below is sifted; (second - min) / second, 0..1
    double focus_exclusion = 0.25;  ///< no blocks where |e| is below: the cone around the focus of expansion
};

}  // namespace flownav::flow
