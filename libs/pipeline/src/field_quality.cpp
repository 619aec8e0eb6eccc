#include "field_quality.h"

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
    double n = 0, sum = 0, sum2 = 0, saturated = 0;
    for (int v = 0; v < image.height_px; v += step_px) {
        for (int u = 0; u < image.width_px; u += step_px) {
            const int grey = image.at(u, v);
            n += 1;
            sum += grey;
            sum2 += static_cast<double>(grey) * grey;
            saturated += grey <= black || grey >= white;
        }
    }
    return sum2 / n - (sum / n) * (sum / n) >= variance_min && saturated <= saturated_share_max * n;
}

}  // namespace flownav::pipeline
