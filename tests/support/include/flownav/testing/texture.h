#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace flownav::testing {

/// What a surface looks like. The numbers are those of the column `texture` in objects.csv.
enum class Surface : std::uint8_t {
    Plain = 0,      ///< no texture at all
    Carpet = 1,     ///< rich, from half a metre down to a few millimetres
    Tiles = 2,      ///< regular dark joints, nearly nothing inside
    Lino = 3,       ///< low contrast
    Wall = 4,       ///< painted rough plaster, low contrast
    Patterned = 5,  ///< rich, for objects
    Faint = 6,      ///< wood or metal, low contrast, darker
    Stoneware = 7,  ///< tiles as they are laid: joints, and fine faint specks inside
    Marbled = 8,    ///< linoleum as it is laid: faint flecks and streaks
};

/// The floor of a name: carpet, tiles, lino, plain, stoneware or marbled.
std::optional<Surface> floor_surface(const std::string& name);

struct Texture {
    Surface surface = Surface::Plain;
    double shade = 1.0;      ///< factor on the grey of the surface
    std::uint64_t seed = 0;  ///< same seed, same picture
};

/// The piece of a surface that one pixel sees: a parallelogram around `at_m`, spanned by what one pixel step
/// to the right and one down move on the surface, metres.
struct Footprint {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d right_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d down_m = Eigen::Vector2d::Zero();
};

/// A texture ready for evaluation: band-limited noise, filtered with the footprint it is seen with, so that
/// far texture fades into its mean instead of sparkling.
class TextureSampler {
  public:
    explicit TextureSampler(const Texture& texture);

    /// Mean grey (0..255, not clamped) of the footprint.
    double grey(const Footprint& footprint) const;

  private:
    /// Noise on a lattice that is turned, scaled and moved: x' = cos x + sin y + x0, y' = cos y - sin x + y0.
    struct Octave {
        double cos_per_m, sin_per_m;
        double x, y;
        double spacing_m, per_m;
        double amplitude;
    };
    /// How a footprint is sampled: taps to the right and down, each standing for a piece `width_m` wide.
    struct Taps {
        int right = 1;
        int down = 1;
        double width_m = 0.0;
    };

    static Taps taps_for(double right_m, double down_m, double detail_m);
    static double mean_noise(const Octave& octave, const Footprint& footprint, const Taps& taps);
    void add_octaves(double coarsest_m, double finest_m, double ratio, double amplitude, double growth);
    double tiled(const Footprint& footprint, double inside) const;

    double base_ = 128.0;
    double shade_ = 1.0;
    std::uint64_t seed_ = 0;
    std::vector<Octave> octaves_;
    bool tiled_ = false;
};

}  // namespace flownav::testing
