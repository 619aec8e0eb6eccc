#include "flownav/sim/surface_texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace flownav::sim {
namespace {

Look usual(Surface surface, std::uint64_t seed) {
    return {surface, usual_grey(surface), seed};
}

struct Spread {
    double mean = 0.0;
    double sigma = 0.0;
};

/// Grey values of a row of square footprints of `width_m` across the surface.
std::vector<double> row_of(const Look& look, double width_m, double step_m, int n) {
    const TextureSampler sampler(look);
    std::vector<double> greys;
    greys.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        greys.push_back(
            sampler.grey({{0.37 * i * step_m, 0.93 * i * step_m}, {width_m, 0.0}, {0.0, width_m}}));
    }
    return greys;
}

Spread spread(const std::vector<double>& values) {
    Spread s;
    for (const double v : values) s.mean += v / static_cast<double>(values.size());
    for (const double v : values) s.sigma += (v - s.mean) * (v - s.mean) / static_cast<double>(values.size());
    s.sigma = std::sqrt(s.sigma);
    return s;
}

TEST(Texture, CarpetIsRichLinoIsFaintAndPlainHasNone) {
    const double carpet = spread(row_of(usual(Surface::Carpet, 5), 0.002, 0.05, 2000)).sigma;
    const double lino = spread(row_of(usual(Surface::Lino, 5), 0.002, 0.05, 2000)).sigma;
    EXPECT_GT(carpet, 10.0);
    EXPECT_LT(lino, 0.5 * carpet);
    EXPECT_GT(lino, 1.0);
    EXPECT_LT(spread(row_of(usual(Surface::Plain, 5), 0.002, 0.05, 200)).sigma, 1e-9);
}

TEST(Texture, OtherSeedIsAnotherPicture) {
    const std::vector<double> first = row_of(usual(Surface::Carpet, 5), 0.002, 0.01, 100);
    EXPECT_EQ(first, row_of(usual(Surface::Carpet, 5), 0.002, 0.01, 100));
    EXPECT_NE(first, row_of(usual(Surface::Carpet, 6), 0.002, 0.01, 100));
}

TEST(Texture, FadesIntoItsMeanWhenSeenFromFar) {
    const Spread near = spread(row_of(usual(Surface::Carpet, 5), 0.002, 0.21, 3000));
    const Spread far = spread(row_of(usual(Surface::Carpet, 5), 0.3, 0.21, 3000));
    EXPECT_LT(far.sigma, 0.5 * near.sigma);
    EXPECT_NEAR(far.mean, near.mean, 1.0);
}

TEST(Texture, LongFootprintIsTheMeanOfItsPieces) {
    const TextureSampler sampler(usual(Surface::Carpet, 5));
    double worst = 0.0;
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d at(0.13 * i, 0.07 * i);
        double pieces = 0.0;
        for (int k = 0; k < 16; ++k) {
            pieces +=
                sampler.grey({at + Eigen::Vector2d(0.0, 0.003 * (k - 7.5)), {0.004, 0.0}, {0.0, 0.003}}) / 16;
        }
        worst = std::max(worst, std::abs(pieces - sampler.grey({at, {0.004, 0.0}, {0.0, 0.048}})));
    }
    EXPECT_LT(worst, 3.0);
}

TEST(Texture, TilesHaveAJointEveryThirtyCentimetres) {
    const TextureSampler sampler(usual(Surface::Tiles, 5));
    const auto grey = [&](double x) { return sampler.grey({{x, 0.15}, {0.001, 0.0}, {0.0, 0.001}}); };
    for (const double joint : {-0.3, 0.0, 0.3, 1.2})
        EXPECT_LT(grey(joint + 0.003), grey(joint + 0.15) - 30.0);
}

TEST(Texture, LaidTilesHaveSpecksInsideAndLaidLinoIsFaintButNotBlank) {
    const auto inside = [](Surface surface) {
        const TextureSampler sampler(usual(surface, 5));
        std::vector<double> greys;
        for (int i = 0; i < 400; ++i) {
            const Eigen::Vector2d at(0.05 + 0.0101 * (i % 20), 0.05 + 0.0101 * std::floor(i / 20.0));
            greys.push_back(sampler.grey({at, {0.002, 0.0}, {0.0, 0.002}}));
        }
        return spread(greys).sigma;
    };
    EXPECT_GT(inside(Surface::Stoneware), 2.0);
    EXPECT_LT(inside(Surface::Stoneware), 6.0);
    EXPECT_GT(inside(Surface::Stoneware), 1.5 * inside(Surface::Tiles));
    EXPECT_GT(inside(Surface::Marbled), 1.5);
    EXPECT_LT(inside(Surface::Marbled), 4.0);
}

}  // namespace
}  // namespace flownav::sim
