#pragma once
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <string>

#include "flownav/core/field_status.h"

/// The colours of every picture, chart and page.
namespace flownav::report {

struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    cv::Vec3b bgr() const { return {blue, green, red}; }
    operator cv::Scalar() const { return {double(blue), double(green), double(red)}; }
    /// As in CSS: "#0072b2".
    std::string css() const;
};

namespace palette {

// The palette of Okabe and Ito, whose colours colour-blind readers can tell apart.
constexpr Colour black{0, 0, 0};
constexpr Colour orange{230, 159, 0};
constexpr Colour sky_blue{86, 180, 233};
constexpr Colour green{0, 158, 115};
constexpr Colour yellow{240, 228, 66};
constexpr Colour blue{0, 114, 178};
constexpr Colour vermilion{213, 94, 0};
constexpr Colour purple{204, 121, 167};

constexpr Colour paper{255, 255, 255};
constexpr Colour ink{30, 30, 30};
constexpr Colour grey{153, 153, 153};

// The two runs of a comparison; neither colour stands for better or worse.
constexpr Colour run_a{0, 158, 122};
constexpr Colour run_b{197, 27, 118};
constexpr Colour run_truth{185, 185, 185};

}  // namespace palette

Colour colour_of(FieldStatus status);

/// A style sheet that defines the palette as variables: ":root { --blue: #0072b2; ... }" and a line end.
std::string css_variables();

}  // namespace flownav::report
