#include "flownav/flow/brightness.h"

#include <algorithm>
#include <cmath>

#include "flownav/flow/kernel.h"

namespace flownav {
namespace {

constexpr double block_pixels = static_cast<double>(block_px) * block_px;
constexpr double gain_max = 2.0;      // either way; beyond that little is left of an 8-bit image
constexpr double variance_min = 1.0;  // grey levels squared; below there is nothing to tell a gain from
constexpr int rounds = 3;
constexpr double kept_share = 0.7;  // of the blocks, those that follow the others best

struct Sums {
    int greys = 0, squares = 0;
};

// Products of 16-bit numbers, as the vectoriser knows an instruction for their sums.
Sums sums_of(const ImageView& image, const Eigen::Vector2i& corner_px) {
    Sums s;
    for (int v = 0; v < block_px; ++v) {
        const std::uint8_t* row = image.row(corner_px.y() + v) + corner_px.x();
        for (int u = 0; u < block_px; ++u) {
            const std::int16_t grey = row[u];
            s.greys += grey;
            s.squares += grey * grey;
        }
    }
    return s;
}

bool inside(const Eigen::Vector2i& corner_px, const ImageView& image) {
    return corner_px.x() >= 0 && corner_px.y() >= 0 && corner_px.x() + block_px <= image.width_px &&
           corner_px.y() + block_px <= image.height_px;
}

void collect(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
             const std::vector<Eigen::Vector2i>& bias_px, std::vector<GreySums>& sums) {
    sums.clear();
    for (std::size_t i = 0; i < layout.size(); ++i) {
        const Eigen::Vector2i expected_px = layout.corner_px[i] + bias_px[i];
        if (!inside(expected_px, newer)) continue;
        const Sums before = sums_of(reference, layout.corner_px[i]);
        const Sums after = sums_of(newer, expected_px);
        sums.push_back({static_cast<double>(before.greys), static_cast<double>(before.squares),
                        static_cast<double>(after.greys), static_cast<double>(after.squares), 0.0});
    }
}

/// From the first `used` blocks.
Brightness fit(const std::vector<GreySums>& sums, std::size_t used) {
    GreySums total;
    for (std::size_t i = 0; i < used; ++i) {
        total.reference += sums[i].reference;
        total.reference2 += sums[i].reference2;
        total.newer += sums[i].newer;
        total.newer2 += sums[i].newer2;
    }
    const double n = block_pixels * static_cast<double>(used);
    const double mean = total.reference / n;
    const double newer_mean = total.newer / n;
    const double variance = total.reference2 / n - mean * mean;
    const double newer_variance = total.newer2 / n - newer_mean * newer_mean;
    Brightness b;
    if (variance > variance_min && newer_variance > variance_min)
        b.gain = std::clamp(std::sqrt(newer_variance / variance), 1.0 / gain_max, gain_max);
    b.offset = newer_mean - b.gain * mean;
    return b;
}

}  // namespace

GreyTable grey_table(const Brightness& brightness) {
    GreyTable table;
    for (std::size_t grey = 0; grey < table.size(); ++grey) {
        const double shown = std::round(brightness.gain * static_cast<double>(grey) + brightness.offset);
        table[grey] = static_cast<std::uint8_t>(std::clamp(shown, 0.0, 255.0));
    }
    return table;
}

Brightness compare_brightness(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                              const std::vector<Eigen::Vector2i>& bias_px, std::vector<GreySums>& sums) {
    collect(reference, newer, layout, bias_px, sums);
    if (sums.empty()) return {};
    const auto kept = static_cast<std::size_t>(std::ceil(kept_share * static_cast<double>(sums.size())));
    Brightness b = fit(sums, sums.size());
    for (int round = 0; round < rounds; ++round) {
        for (GreySums& s : sums)
            s.difference = std::abs(s.newer - b.gain * s.reference - b.offset * block_pixels);
        std::nth_element(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(kept - 1), sums.end(),
                         [](const GreySums& p, const GreySums& q) { return p.difference < q.difference; });
        b = fit(sums, kept);
    }
    return b;
}

}  // namespace flownav
