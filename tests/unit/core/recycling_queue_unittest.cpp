#include "flownav/core/recycling_queue.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>

namespace flownav {
namespace {

TEST(RecyclingQueue, KeepsTheOrderHoweverItGrowsAndShrinks) {
    std::mt19937 random(4);
    RecyclingQueue<int> queue;
    std::deque<int> expected;
    for (int i = 0; i < 10000; ++i) {
        if (random() % 100 < (i % 1000 < 500 ? 60U : 40U)) {
            queue.push() = i;
            expected.push_back(i);
        } else if (!expected.empty()) {
            ASSERT_EQ(queue.front(), expected.front());
            queue.pop();
            expected.pop_front();
        }
        ASSERT_EQ(queue.size(), expected.size());
    }
    for (; !expected.empty(); expected.pop_front(), queue.pop()) ASSERT_EQ(queue.front(), expected.front());
    EXPECT_TRUE(queue.empty());
}

TEST(RecyclingQueue, WhatGoesLeavesItsMemoryToWhatComes) {
    RecyclingQueue<std::vector<int>> queue;
    queue.push().resize(1000);
    const int* memory = queue.front().data();
    queue.pop();
    EXPECT_EQ(queue.push().data(), memory);
}

}  // namespace
}  // namespace flownav
