#pragma once
#include <string>

namespace flownav::flow {

/// Refinement of the integer minimum of the SAD surface.
enum class Subpixel {
    None,      ///< integer vectors, as printed in [P]
    V,         ///< equiangular: two lines of opposite slope through the three costs around the minimum
    Parabola,  ///< a parabola through the three costs around the minimum
};

/// Compensation of exposure that changes from image to image.
enum class BrightnessModel {
    Constant,  ///< none, as [P]
    Image,     ///< one gain and one offset per image
};

struct FlowParams {
    std::string matcher = "sad";  ///< name of a registered matcher; "sad": exhaustive block matching
    int blocks = 350;             ///< number of 16x16 blocks; 16..2000
    Subpixel subpixel = Subpixel::V;
    BrightnessModel brightness = BrightnessModel::Image;
    double confidence_min = 0.06;   ///< smallest accepted (second - min) / second, 0..1
    double focus_exclusion = 0.25;  ///< smallest |e| of a block: excludes the cone around the FOE
};

}  // namespace flownav::flow
