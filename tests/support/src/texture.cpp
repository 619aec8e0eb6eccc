#include "flownav/testing/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "flownav/testing/random.h"

namespace flownav::testing {
namespace {

using Eigen::Vector2d;

constexpr int lattice_size = 256;
constexpr int lattice_mask = lattice_size - 1;
using Lattice = std::array<float, lattice_size * lattice_size>;

/// Random values in -1..1 on an integer lattice that repeats every 256 points; every octave of every texture
/// reads it with another scale, angle and offset.
const Lattice& lattice() {
    static const Lattice values = [] {
        Lattice v{};
        Random random(20000);
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

/// How a footprint is sampled: taps to the right and down, each averaging about `width_m`.
struct Taps {
    int right = 1;
    int down = 1;
    double width_m = 0.0;
};

/// Enough taps that each covers a roughly square piece no larger than half of the detail, or less than the
/// short side of the footprint.
Taps taps_for(double right_m, double down_m, double detail_m) {
    constexpr double most = 12.0;
    const double target = std::max(0.75 * std::min(right_m, down_m), 0.5 * detail_m);
    Taps taps;
    taps.right = static_cast<int>(std::clamp(std::ceil(right_m / target), 1.0, most));
    taps.down = static_cast<int>(std::clamp(std::ceil(down_m / target), 1.0, most));
    taps.width_m = std::max(right_m / taps.right, down_m / taps.down);
    return taps;
}

/// What is left of noise with lattice spacing s after averaging over w: close to the response of a box.
double attenuation(double w_over_s) {
    const double q = 1.0 - 0.25 * w_over_s * w_over_s;
    return q > 0.0 ? q * q : 0.0;
}

/// Puts a lattice coordinate where adding a footprint keeps it positive and float keeps it precise.
float wrapped(double coordinate) {
    const double period = lattice_size;
    return static_cast<float>(coordinate - period * std::floor(coordinate / period) + period);
}

struct Line {
    float start, right, down;  ///< value at the first tap and the steps to its neighbours
};

Line line_of(double at, double right, double down, const Taps& taps) {
    const double first = at - 0.5 * (right + down) + 0.5 * (right / taps.right + down / taps.down);
    return {wrapped(first), static_cast<float>(right / taps.right), static_cast<float>(down / taps.down)};
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

std::optional<Surface> floor_surface(const std::string& name) {
    if (name == "carpet") return Surface::Carpet;
    if (name == "tiles") return Surface::Tiles;
    if (name == "lino") return Surface::Lino;
    if (name == "plain") return Surface::Plain;
    return std::nullopt;
}

TextureSampler::TextureSampler(const Texture& texture) : shade_(texture.shade), seed_(texture.seed) {
    switch (texture.surface) {
        case Surface::Plain:
            base_ = 110.0;
            break;
        case Surface::Carpet:
            base_ = 105.0;
            add_octaves(0.45, 0.0025, 0.55, 10.0, 1.04);
            break;
        case Surface::Tiles:
            base_ = 135.0;
            tiled_ = true;
            add_octaves(0.6, 0.01, 0.4, 1.2, 1.0);
            break;
        case Surface::Lino:
            base_ = 120.0;
            add_octaves(0.3, 0.004, 0.5, 2.2, 1.05);
            break;
        case Surface::Wall:
            base_ = 150.0;
            add_octaves(0.5, 0.006, 0.5, 2.5, 1.0);
            break;
        case Surface::Patterned:
            base_ = 100.0;
            add_octaves(0.20, 0.003, 0.55, 11.0, 1.0);
            break;
        case Surface::Faint:
            base_ = 80.0;
            add_octaves(0.15, 0.006, 0.5, 2.0, 1.0);
            break;
    }
}

void TextureSampler::add_octaves(double coarsest_m, double finest_m, double ratio, double amplitude,
                                 double growth) {
    Random random(seed_);
    for (double spacing = coarsest_m; spacing >= finest_m; spacing *= ratio, amplitude *= growth) {
        const double angle = random.uniform(0.0, 2.0 * M_PI);
        const double c = std::cos(angle) / spacing;
        const double s = std::sin(angle) / spacing;
        octaves_.push_back({c, s, -s, c, random.uniform(0.0, lattice_size), random.uniform(0.0, lattice_size),
                            spacing, amplitude});
    }
}

double TextureSampler::grey(const Footprint& f) const {
    const Lattice& values = lattice();
    const double right_m = std::max(f.right_m.norm(), 1e-6);
    const double down_m = std::max(f.down_m.norm(), 1e-6);
    double sum = base_;
    for (const Octave& o : octaves_) {
        const Taps taps = taps_for(right_m, down_m, o.spacing_m);
        const double weight = o.amplitude * attenuation(taps.width_m / o.spacing_m);
        if (weight < 0.02 * o.amplitude) continue;
        const auto project = [](double px, double py, const Vector2d& p) { return px * p.x() + py * p.y(); };
        const Line x = line_of(project(o.ax, o.ay, f.at_m) + o.ox, project(o.ax, o.ay, f.right_m),
                               project(o.ax, o.ay, f.down_m), taps);
        const Line y = line_of(project(o.bx, o.by, f.at_m) + o.oy, project(o.bx, o.by, f.right_m),
                               project(o.bx, o.by, f.down_m), taps);
        float total = 0.0F;
        for (int j = 0; j < taps.down; ++j) {
            for (int i = 0; i < taps.right; ++i) {
                const auto fi = static_cast<float>(i);
                const auto fj = static_cast<float>(j);
                total +=
                    noise(values, x.start + fi * x.right + fj * x.down, y.start + fi * y.right + fj * y.down);
            }
        }
        sum += weight * static_cast<double>(total) / (taps.right * taps.down);
    }
    return shade_ * (tiled_ ? tiled(f, sum) : sum);
}

double TextureSampler::tiled(const Footprint& f, double inside) const {
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

}  // namespace flownav::testing
