#include "flownav/math/ring.h"

#include <gtest/gtest.h>

namespace flownav {
namespace {

TEST(Ring, KeepsTheNewestValuesInTheirOrder) {
    Ring<int, 3> ring;
    EXPECT_TRUE(ring.empty());
    for (int i = 1; i <= 5; ++i) ring.push(i);
    ASSERT_EQ(ring.size(), 3U);
    EXPECT_EQ(ring.front(), 3);
    EXPECT_EQ(ring[1], 4);
    EXPECT_EQ(ring.back(), 5);
    ring.clear();
    EXPECT_TRUE(ring.empty());
}

TEST(Ring, FindsTheFirstValueThatIsNotBefore) {
    Ring<int, 4> ring;
    for (const int value : {10, 20, 30, 40, 50}) ring.push(value);  // 10 is gone
    const auto first_not_before = [&ring](int value) {
        return ring.partition_point([value](int v) { return v < value; });
    };
    EXPECT_EQ(first_not_before(5), 0U);
    EXPECT_EQ(first_not_before(20), 0U);
    EXPECT_EQ(first_not_before(21), 1U);
    EXPECT_EQ(first_not_before(50), 3U);
    EXPECT_EQ(first_not_before(51), 4U);
}

}  // namespace
}  // namespace flownav
