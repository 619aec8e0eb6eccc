#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "flownav/sim/world.h"

namespace flownav::sim {

/// Grey level at which the contrasts of a surface are those of the method's scenes; Look::grey scales both.
double usual_grey(Surface surface);

/// Piece of a surface that one pixel sees: a parallelogram around `at_m`, spanned by the steps on the surface
/// from this pixel to the next one right and down, metres.
struct TextureFootprint {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d right_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d down_m = Eigen::Vector2d::Zero();
};

/// A texture ready for evaluation: band-limited noise, filtered with the footprint it is seen with, so that
/// far texture fades into its mean instead of sparkling.
class TextureSampler {
  public:
    explicit TextureSampler(const Look& look);

    /// Mean grey (0..255, not clamped) of the footprint.
    double grey(const TextureFootprint& footprint) const;

  private:
    /// Noise on a lattice that is turned, scaled and moved: x' = cos x + sin y + x0, y' = cos y - sin x + y0.
    struct Octave {
        double cos_per_m, sin_per_m;
        double x, y;
        double spacing_m, per_m;
        double amplitude;
    };
    /// Samples of a footprint: number of them right and down, each of a piece `width_m` wide.
    struct Taps {
        int right = 1;
        int down = 1;
        double width_m = 0.0;
    };

    static Taps taps_for(double right_m, double down_m, double detail_m);
    static double mean_noise(const Octave& octave, const TextureFootprint& footprint, const Taps& taps);
    void add_octaves(double coarsest_m, double finest_m, double ratio, double amplitude, double growth);
    double tiled(const TextureFootprint& footprint, double inside) const;

    double base_;
    double shade_;
    std::uint64_t seed_;
    std::vector<Octave> octaves_;
    bool tiled_ = false;
};

}  // namespace flownav::sim
