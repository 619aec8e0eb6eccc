#include "flownav/sim/surface_texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "flownav/sim/random.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;

constexpr std::size_t lattice_points = 256;
constexpr int lattice_size = lattice_points;
constexpr int lattice_mask = lattice_size - 1;
using Lattice = std::array<float, lattice_points * lattice_points>;

/// Random values in -1..1 on an integer lattice that repeats every 256 points; every octave of every texture
/// reads it with another scale, angle and offset.
const Lattice& lattice() {
    static const Lattice values = [] {
        Lattice v{};
        HashRandom random(20000);
        for (float& x : v) x = static_cast<float>(random.uniform(-1.0, 1.0));
        return v;
    }();
    return values;
}

/// Smooth interpolation of the lattice at coordinates >= 0.
float noise(const Lattice& values, float x, float y) {
    const int ix = static_cast<int>(x);
    const int iy = static_cast<int>(y);
    const float fx = x - static_cast<float>(ix);
    const float fy = y - static_cast<float>(iy);
    const float wx = fx * fx * (3.0F - 2.0F * fx);
    const float wy = fy * fy * (3.0F - 2.0F * fy);
    const int x0 = ix & lattice_mask;
    const int x1 = (ix + 1) & lattice_mask;
    const float* row0 = values.data() + static_cast<std::ptrdiff_t>(iy & lattice_mask) * lattice_size;
    const float* row1 = values.data() + static_cast<std::ptrdiff_t>((iy + 1) & lattice_mask) * lattice_size;
    const float top = row0[x0] + wx * (row0[x1] - row0[x0]);
    const float bottom = row1[x0] + wx * (row1[x1] - row1[x0]);
    return top + wy * (bottom - top);
}

int steps(double length_m, double step_m) {
    constexpr double most = 12.0;
    return static_cast<int>(std::min(length_m / step_m + 0.999, most));
}

/// What is left of noise with lattice spacing s after averaging over w: close to the response of a box.
double attenuation(double w_over_s) {
    const double q = 1.0 - 0.25 * w_over_s * w_over_s;
    return q > 0.0 ? q * q : 0.0;
}

/// Puts a lattice coordinate where adding a footprint keeps it positive and float keeps it precise.
float wrapped(double coordinate) {
    const auto periods = static_cast<std::int64_t>(coordinate) & ~static_cast<std::int64_t>(lattice_mask);
    return static_cast<float>(coordinate - static_cast<double>(periods) + lattice_size);
}

/// Share of [x - w/2, x + w/2] that lies in joints of width `joint` repeated every `period`.
double joint_share(double x, double w, double period, double joint) {
    const auto covered = [&](double at) {
        const double whole = std::floor(at / period);
        return whole * joint + std::min(at - whole * period, joint);
    };
    return (covered(x + 0.5 * w) - covered(x - 0.5 * w)) / w;
}

constexpr double tile_m = 0.30;
constexpr double joint_m = 0.006;

}  // namespace

double usual_grey(Surface surface) {
    switch (surface) {
        case Surface::Plain:
            return 110.0;
        case Surface::Carpet:
            return 115.0;
        case Surface::Tiles:
        case Surface::Stoneware:
            return 135.0;
        case Surface::Lino:
        case Surface::Marbled:
            return 120.0;
        case Surface::Wall:
            return 150.0;
        case Surface::Patterned:
            return 100.0;
        case Surface::Faint:
            return 80.0;
        case Surface::Lamp:
            return 128.0;
    }
    return 128.0;
}

TextureSampler::TextureSampler(const Look& look)
    : base_(usual_grey(look.surface)), shade_(look.grey / base_), seed_(look.seed) {
    switch (look.surface) {
        case Surface::Plain:
        case Surface::Lamp:
            break;
        case Surface::Carpet:
            add_octaves(0.45, 0.0025, 0.55, 7.0, 1.12);
            break;
        case Surface::Tiles:
            tiled_ = true;
            add_octaves(0.6, 0.005, 0.4, 2.0, 1.0);
            break;
        case Surface::Lino:
            add_octaves(0.3, 0.004, 0.5, 2.2, 1.05);
            break;
        case Surface::Wall:
            add_octaves(0.5, 0.006, 0.5, 2.5, 1.0);
            break;
        case Surface::Patterned:
            add_octaves(0.20, 0.003, 0.55, 11.0, 1.0);
            break;
        case Surface::Faint:
            add_octaves(0.15, 0.006, 0.5, 2.0, 1.0);
            break;
        case Surface::Stoneware:
            tiled_ = true;
            add_octaves(0.24, 0.05, 0.45, 1.5, 1.0);
            add_octaves(0.012, 0.003, 0.6, 5.0, 1.0);
            break;
        case Surface::Marbled:
            add_octaves(0.3, 0.03, 0.5, 2.0, 1.0);
            add_octaves(0.012, 0.004, 0.6, 3.5, 1.0);
            break;
    }
}

void TextureSampler::add_octaves(double coarsest_m, double finest_m, double ratio, double amplitude,
                                 double growth) {
    HashRandom random(seed_);
    double spacing = coarsest_m;
    while (spacing >= finest_m) {
        const double angle = random.uniform(0.0, 2.0 * M_PI);
        octaves_.push_back({std::cos(angle) / spacing, std::sin(angle) / spacing,
                            random.uniform(0.0, lattice_size), random.uniform(0.0, lattice_size), spacing,
                            1.0 / spacing, amplitude});
        spacing *= ratio;
        amplitude *= growth;
    }
}

// Enough taps that each covers a roughly square piece: half of the detail, or the short side of the
/// footprint.
TextureSampler::Taps TextureSampler::taps_for(double right_m, double down_m, double detail_m) {
    const double target_m = std::max(std::min(right_m, down_m), 0.5 * detail_m);
    Taps taps;
    if (target_m >= std::max(right_m, down_m)) {
        taps.width_m = std::max(right_m, down_m);
        return taps;
    }
    taps.right = std::max(1, steps(right_m, target_m));
    taps.down = std::max(1, steps(down_m, target_m));
    taps.width_m = std::max(right_m / taps.right, down_m / taps.down);
    return taps;
}

double TextureSampler::grey(const TextureFootprint& f) const {
    const double right_m = std::max(f.right_m.norm(), 1e-6);
    const double down_m = std::max(f.down_m.norm(), 1e-6);
    double sum = base_;
    for (const Octave& o : octaves_) {
        const Taps taps = taps_for(right_m, down_m, o.spacing_m);
        const double left = attenuation(taps.width_m * o.per_m);
        if (left < 0.03) continue;
        sum += o.amplitude * left * mean_noise(o, f, taps);
    }
    return shade_ * (tiled_ ? tiled(f, sum) : sum);
}

double TextureSampler::mean_noise(const Octave& o, const TextureFootprint& f, const Taps& taps) {
    const Lattice& values = lattice();
    const auto x_of = [&](const Vector2d& p) { return o.cos_per_m * p.x() + o.sin_per_m * p.y(); };
    const auto y_of = [&](const Vector2d& p) { return o.cos_per_m * p.y() - o.sin_per_m * p.x(); };
    if (taps.right == 1 && taps.down == 1)
        return static_cast<double>(noise(values, wrapped(x_of(f.at_m) + o.x), wrapped(y_of(f.at_m) + o.y)));
    const Vector2d right = f.right_m / taps.right;
    const Vector2d down = f.down_m / taps.down;
    const Vector2d first = f.at_m - 0.5 * (f.right_m + f.down_m) + 0.5 * (right + down);
    const float x0 = wrapped(x_of(first) + o.x);
    const float y0 = wrapped(y_of(first) + o.y);
    const auto x_right = static_cast<float>(x_of(right));
    const auto y_right = static_cast<float>(y_of(right));
    const auto x_down = static_cast<float>(x_of(down));
    const auto y_down = static_cast<float>(y_of(down));
    float total = 0.0F;
    for (int j = 0; j < taps.down; ++j) {
        for (int i = 0; i < taps.right; ++i) {
            const auto fi = static_cast<float>(i);
            const auto fj = static_cast<float>(j);
            total += noise(values, x0 + fi * x_right + fj * x_down, y0 + fi * y_right + fj * y_down);
        }
    }
    return static_cast<double>(total) / (taps.right * taps.down);
}

double TextureSampler::tiled(const TextureFootprint& f, double inside) const {
    const Taps taps = taps_for(f.right_m.norm() + 1e-6, f.down_m.norm() + 1e-6, joint_m);
    double total = 0.0;
    for (int j = 0; j < taps.down; ++j) {
        for (int i = 0; i < taps.right; ++i) {
            const Vector2d p = f.at_m + ((i + 0.5) / taps.right - 0.5) * f.right_m +
                               ((j + 0.5) / taps.down - 0.5) * f.down_m;
            const double across = 1.0 - joint_share(p.x(), taps.width_m, tile_m, joint_m);
            const double along = 1.0 - joint_share(p.y(), taps.width_m, tile_m, joint_m);
            const auto column = static_cast<std::int64_t>(std::floor(p.x() / tile_m));
            const auto row = static_cast<std::int64_t>(std::floor(p.y() / tile_m));
            const double own = 2.0 * normal_of_bits(mix(mix(seed_, static_cast<std::uint64_t>(column)),
                                                        static_cast<std::uint64_t>(row)));
            const double joint_grey = 0.55 * base_;
            total += joint_grey + across * along * (inside + own - joint_grey);
        }
    }
    return total / (taps.right * taps.down);
}

}  // namespace flownav::sim
