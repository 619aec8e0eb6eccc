#include "texture_tile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

#include "flownav/sim/random.h"

namespace flownav::sim {
namespace {

/// Noise of wavelengths between two limits, with the same power in every octave.
struct Band {
    double longest_m;
    double shortest_m;
    double contrast;  ///< standard deviation over the mean grey
};

constexpr double slab_m = 0.30;
constexpr double joint_m = 0.006;
constexpr double joint_shade = 0.55;
constexpr double slab_contrast = 0.015;  ///< of one slab to the next

std::vector<Band> bands_of(Surface surface) {
    switch (surface) {
        case Surface::Plain:
        case Surface::Lamp:
            return {};
        case Surface::Carpet:
            return {{0.9, 0.1, 0.07}, {0.1, 0.006, 0.115}};
        case Surface::Tiles:
        case Surface::Stoneware:
            return {{0.5, 0.1, 0.008}, {0.024, 0.006, 0.027}};
        case Surface::Lino:
        case Surface::Marbled:
            return {{0.6, 0.06, 0.014}, {0.024, 0.008, 0.022}};
        case Surface::Patterned:
            return {{0.4, 0.006, 0.125}};
        case Surface::Wall:
        case Surface::Faint:
            return {{0.3, 0.012, 0.022}};
    }
    return {};
}

/// Amplitude at `per_m` waves a metre: 1/f within the band, and soft at its ends.
double amplitude(const Band& band, double per_m) {
    if (per_m <= 0.0) return 0.0;
    const double low = 1.0 / band.longest_m;
    const double high = 1.0 / band.shortest_m;
    return std::exp(-std::pow(per_m / high, 4.0) - std::pow(low / per_m, 4.0)) / per_m;
}

/// Standard deviation 1, mean 0; periodic, since the spectrum is discrete.
cv::Mat1f noise(const Band& band, const TileGrid& grid, Random& random) {
    const int n = grid.size_px;
    cv::Mat1f picture(n, n);
    for (float& value : picture) value = static_cast<float>(random.normal(1.0));
    cv::Mat2f spectrum;
    cv::dft(picture, spectrum, cv::DFT_COMPLEX_OUTPUT);
    const double length_m = n * grid.texel_m;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const double per_m = std::hypot(std::min(x, n - x), std::min(y, n - y)) / length_m;
            spectrum(y, x) *= static_cast<float>(amplitude(band, per_m));
        }
    }
    cv::idft(spectrum, picture, cv::DFT_REAL_OUTPUT | cv::DFT_SCALE);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(picture, mean, deviation);
    picture.convertTo(picture, CV_32F, 1.0 / deviation[0], -mean[0] / deviation[0]);
    return picture;
}

/// Share of texel `i` that lies in the joint at the low end of every slab.
double joint_share(int i, double texel_m) {
    const double low_m = std::fmod(i * texel_m, slab_m);
    return std::clamp((joint_m - low_m) / texel_m, 0.0, 1.0);
}

void lay_slabs(cv::Mat1f& shade, const TileGrid& grid, Random& random) {
    const int slabs = static_cast<int>(std::lround(grid.size_px * grid.texel_m / slab_m));
    std::vector<double> own(static_cast<std::size_t>(slabs) * static_cast<std::size_t>(slabs));
    for (double& value : own) value = random.normal(slab_contrast);
    const auto slab = [&](int i) { return std::min(static_cast<int>(i * grid.texel_m / slab_m), slabs - 1); };
    for (int y = 0; y < grid.size_px; ++y) {
        const double free_y = 1.0 - joint_share(y, grid.texel_m);
        for (int x = 0; x < grid.size_px; ++x) {
            const double free = free_y * (1.0 - joint_share(x, grid.texel_m));
            const auto index = static_cast<std::size_t>(slab(y) * slabs + slab(x));
            const double inside = shade(y, x) + own[index];
            shade(y, x) = static_cast<float>(joint_shade + free * (inside - joint_shade));
        }
    }
}

}  // namespace

TextureTile texture_tile(const Look& look, const TileGrid& grid) {
    Random random(look.seed);
    cv::Mat1f shade(grid.size_px, grid.size_px, 1.0F);
    for (const Band& band : bands_of(look.surface)) shade += band.contrast * noise(band, grid, random);
    if (look.surface == Surface::Tiles || look.surface == Surface::Stoneware) lay_slabs(shade, grid, random);
    TextureTile tile;
    tile.size_m = grid.size_px * grid.texel_m;
    shade.convertTo(tile.grey, CV_8U, look.grey);
    return tile;
}

}  // namespace flownav::sim
