#include "background.h"

#include <gtest/gtest.h>

namespace flownav::motion {
namespace {

using Eigen::Vector2d;

constexpr double gap_rad = 1e-4;

/// Adds `count` samples around `omega_rad`, closer together than the gap, on a line of `width` about the
/// centre.
void add(std::vector<OmegaSample>& samples, int count, double omega_rad, double width) {
    for (int i = 0; i < count; ++i) {
        const double share = (i + 0.5) / count - 0.5;
        samples.push_back({omega_rad + 0.5e-4 * share, Vector2d(width * share, 0.1)});
    }
}

double background_of(std::vector<OmegaSample> samples) {
    std::vector<double> values;
    return background_omega(samples, gap_rad, values);
}

TEST(Background, IsTheWholeOfAWorldThatStandsStill) {
    std::vector<OmegaSample> samples;
    add(samples, 100, 0.02, 1.0);
    EXPECT_NEAR(background_of(samples), 0.02, 1e-4);
}

TEST(Background, IsWhatIsSpreadWidestEvenWhenAMoverHasMoreVectors) {
    std::vector<OmegaSample> samples;
    add(samples, 40, 0.02, 1.0);
    add(samples, 60, 0.05, 0.3);
    EXPECT_NEAR(background_of(samples), 0.02, 1e-4);
}

TEST(Background, IsNeverAHandfulOfOutliersHoweverFarApart) {
    std::vector<OmegaSample> samples;
    add(samples, 95, 0.02, 0.5);
    add(samples, 5, 0.05, 2.0);
    EXPECT_NEAR(background_of(samples), 0.02, 1e-4);
}

TEST(Background, WithoutAnyClusterIsTheShorthOfAll) {
    std::vector<OmegaSample> samples(20, {0.0, Vector2d(0.0, 0.0)});
    for (int i = 0; i < 20; ++i) samples[i].omega_rad = 0.01 * i;
    EXPECT_NEAR(background_of(samples), 0.05, 0.05);
}

TEST(Background, OfNothingIsZero) {
    EXPECT_EQ(background_of({}), 0.0);
}

}  // namespace
}  // namespace flownav::motion
