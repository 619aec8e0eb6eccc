#include "statistics.h"

#include <gtest/gtest.h>

namespace flownav::fidelity {
namespace {

TEST(Moments, GiveMeanSpreadAndMagnitude) {
    Moments m;
    for (const double value : {1.0, -3.0, 5.0}) m.add(value);
    EXPECT_DOUBLE_EQ(m.mean(), 1.0);
    EXPECT_DOUBLE_EQ(m.mean_magnitude(), 3.0);
    EXPECT_DOUBLE_EQ(m.rms(), std::sqrt(35.0 / 3.0));
    EXPECT_NEAR(m.deviation(), std::sqrt(35.0 / 3.0 - 1.0), 1e-12);
}

TEST(Moments, OfTwoDrivesAreThoseOfAllTheirValues) {
    Moments first;
    Moments second;
    Moments all;
    for (const double value : {1.0, 2.0}) first.add(value), all.add(value);
    for (const double value : {-4.0, 7.0}) second.add(value), all.add(value);
    first.add(second);
    EXPECT_DOUBLE_EQ(first.deviation(), all.deviation());
    EXPECT_DOUBLE_EQ(first.mean_magnitude(), all.mean_magnitude());
}

TEST(Moments, OfNothingAreNotANumber) {
    EXPECT_TRUE(std::isnan(Moments{}.mean()));
    EXPECT_TRUE(std::isnan(Moments{}.rms()));
    EXPECT_TRUE(std::isnan(Moments{}.deviation()));
    EXPECT_TRUE(std::isnan(Share{}.percent()));
    EXPECT_TRUE(std::isnan(median({})));
}

TEST(Share, CountsHits) {
    Share share;
    for (const bool hit : {true, false, false, true, true}) share.add(hit);
    EXPECT_DOUBLE_EQ(share.percent(), 60.0);
    share.add(Share{0, 5});
    EXPECT_DOUBLE_EQ(share.percent(), 30.0);
}

TEST(Median, IsTheMiddleOrTheMeanOfTheTwoInTheMiddle) {
    EXPECT_DOUBLE_EQ(median({5.0, 1.0, 3.0}), 3.0);
    EXPECT_DOUBLE_EQ(median({4.0, 1.0, 3.0, 9.0}), 3.5);
}

}  // namespace
}  // namespace flownav::fidelity
