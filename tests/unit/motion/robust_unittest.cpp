#include "flownav/motion/robust.h"

#include <gtest/gtest.h>

#include <vector>

#include "flownav/sim/random.h"

namespace flownav::motion {
namespace {

double shorth_of(std::vector<double> values) {
    return shorth(values);
}

double deviation_of(std::vector<double> values) {
    return robust_deviation(values);
}

TEST(Shorth, OfNothingIsZero) {
    EXPECT_EQ(shorth_of({}), 0.0);
}

TEST(Shorth, OfOneIsTheValueAndOfTwoTheMean) {
    EXPECT_EQ(shorth_of({7.5}), 7.5);
    EXPECT_EQ(shorth_of({1.0, 4.0}), 2.5);
}

TEST(Shorth, IsTheCentreOfTheShortestHalf) {
    EXPECT_EQ(shorth_of({10, 2, 0, 1}), 1.0);
    EXPECT_EQ(shorth_of({0, 50, 51, 52, 53, 200}), 51.5);
}

TEST(Shorth, TakesTheFirstOfEquallyShortIntervals) {
    EXPECT_EQ(shorth_of({0, 1, 2, 3, 4, 5}), 1.5);
    EXPECT_EQ(shorth_of({5, 4, 3, 2, 1, 0}), 1.5);
}

TEST(Shorth, DoesNotMoveWhenLessThanHalfOfTheValuesAreWild) {
    std::vector<double> values = {0.9, 0.95, 1.0, 1.05, 1.1, 1.02};
    values.insert(values.end(), {1e6, -1e6, 300, -40, 17});
    EXPECT_NEAR(shorth_of(values), 1.0, 0.1);
}

TEST(RobustDeviation, OfGaussianValuesIsTheirDeviation) {
    sim::HashRandom random(3);
    std::vector<double> values(20001);
    for (double& value : values) value = random.normal(2.0);
    EXPECT_NEAR(deviation_of(values), 2.0, 0.06);
}

TEST(RobustDeviation, IsNotMovedByAFewWildValues) {
    EXPECT_NEAR(deviation_of({-1, 1, 1, -1, 1, 1e9, -1e9}), 1.4826, 1e-12);
    EXPECT_EQ(deviation_of({}), 0.0);
}

TEST(Biweight, TrustsSmallResidualsAndIgnoresLargeOnes) {
    EXPECT_EQ(biweight(0.0), 1.0);
    EXPECT_EQ(biweight(4.685), 0.0);
    EXPECT_EQ(biweight(-100.0), 0.0);
    EXPECT_EQ(biweight(1.5), biweight(-1.5));
    EXPECT_NEAR(biweight(4.685 / 2), 0.5625, 1e-12);  // (1 - 1/4)^2
    for (int i = 1; i < 46; ++i) EXPECT_GT(biweight(0.1 * (i - 1)), biweight(0.1 * i));
}

}  // namespace
}  // namespace flownav::motion
