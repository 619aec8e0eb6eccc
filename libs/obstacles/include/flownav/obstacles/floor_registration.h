#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "flownav/obstacles/floor_warp.h"

namespace flownav::obstacles {

/// Standard deviations of the errors of a measured motion, and of the floor's slopes.
struct PairPrior {
    double forward_m = 0.0;
    double right_m = 0.0;
    double omega_rad = 0.003;
    double pitch_rad = 0.002;
    double roll_rad = 0.002;
    double slope = 0.001;
    double cross_slope = 0.001;
};

/// Working memory of register_floor().
struct RegistrationScratch {
    struct Pixel {
        float u, v;
        float grey;
        float gx, gy;
    };
    std::vector<Pixel> pixels;
    std::vector<double> residuals;
    std::vector<double> sorted;
    std::vector<std::array<float, 7>> jacobians;
};

/// Room for images of so many pixels, so that no registration allocates.
void reserve(RegistrationScratch& scratch, std::size_t pixels);

/// Chooses the pixels of `newer` that register_floor() compares: the strongest edges below the horizon.
/// `noise`: standard deviation of differences of grey levels.
void choose_floor_pixels(const LevelImage& newer, double noise, RegistrationScratch& scratch);

/// Corrects `measured` so that the chosen pixels of the floor of `newer` fit that of `reference` best: MAP
/// estimate by Gauss-Newton with Tukey's weights. Returns `measured` when there are too few pixels.
PairMotion register_floor(const LevelImage& reference, const LevelImage& newer, const PairMotion& measured,
                          const PairPrior& prior, double noise, RegistrationScratch& scratch);

}  // namespace flownav::obstacles
