#include "flownav/math/order_statistic.h"

#include <gtest/gtest.h>

#include <random>

namespace flownav {
namespace {

void expect_every_one(const std::vector<double>& values) {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 0; k < values.size(); ++k) {
        std::vector<double> shuffled = values;
        ASSERT_EQ(nth_smallest(shuffled, k), sorted[k]) << k << " of " << values.size();
        ASSERT_TRUE(std::is_permutation(shuffled.begin(), shuffled.end(), values.begin()));
    }
}

std::vector<double> noise(int size, int different) {
    std::mt19937 random(static_cast<unsigned>(size));
    std::vector<double> values;
    for (int i = 0; i < size; ++i) values.push_back(static_cast<double>(random() % different) / 8.0 - 3.0);
    return values;
}

TEST(NthSmallest, IsTheOneThatSortingPutsThere) {
    for (const int size : {1, 2, 3, 16, 17, 40, 129, 350}) expect_every_one(noise(size, 1 << 20));
}

TEST(NthSmallest, IsRightAmongEqualOnes) {
    for (const int different : {1, 2, 5}) expect_every_one(noise(120, different));
}

TEST(NthSmallest, IsRightWhenTheyAreSortedAlready) {
    std::vector<double> values = noise(150, 1000);
    std::sort(values.begin(), values.end());
    expect_every_one(values);
    std::reverse(values.begin(), values.end());
    expect_every_one(values);
}

}  // namespace
}  // namespace flownav
