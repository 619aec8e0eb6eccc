#include "field_quality.h"

#include <cstdint>

namespace flownav::pipeline {
namespace {

constexpr int step_px = 8;
constexpr double variance_min = 0.5;  // grey levels squared; a plain floor under noise has more
constexpr double saturated_share_max = 0.9;
constexpr int black = 2;
constexpr int white = 253;

}  // namespace

bool is_picture(const ImageView& image) {
    if (image.empty()) return false;
    std::int64_t counted = 0, greys = 0, squares = 0, saturated = 0;
    for (int v = 0; v < image.height_px; v += step_px) {
        const std::uint8_t* row = image.row(v);
        for (int u = 0; u < image.width_px; u += step_px) {
            const int grey = row[u];
            ++counted;
            greys += grey;
            squares += grey * grey;
            saturated += static_cast<int>(grey <= black) | static_cast<int>(grey >= white);
        }
    }
    const auto n = static_cast<double>(counted);
    const double mean = static_cast<double>(greys) / n;
    return static_cast<double>(squares) / n - mean * mean >= variance_min &&
           static_cast<double>(saturated) <= saturated_share_max * n;
}

}  // namespace flownav::pipeline
