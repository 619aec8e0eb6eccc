#include "reorder_window.h"

#include <gtest/gtest.h>

namespace flownav {
namespace {

using namespace std::chrono_literals;

constexpr ReorderWindow::Time start{};

QueuedObject object(std::int64_t time, std::size_t bytes = 1) {
    return {time, "A", std::vector<std::uint8_t>(bytes)};
}

std::vector<std::int64_t> times(const std::vector<QueuedObject>& objects) {
    std::vector<std::int64_t> all;
    all.reserve(objects.size());
    for (const QueuedObject& o : objects) all.push_back(o.time_100ns);
    return all;
}

using Times = std::vector<std::int64_t>;

TEST(ReorderWindow, ObjectsWaitAndLeaveInOrder) {
    ReorderWindow window(100ms);
    window.push(object(30), start);
    window.push(object(10), start + 50ms);
    window.push(object(20), start + 60ms);
    EXPECT_EQ(times(window.take_ripe(start + 99ms)), Times{});
    EXPECT_EQ(times(window.take_ripe(start + 100ms)), (Times{10, 20, 30})) << "the earlier ones go along";
    EXPECT_EQ(window.late(), 0U);
}

TEST(ReorderWindow, LaterOnesStayUntilTheyAreRipe) {
    ReorderWindow window(100ms);
    window.push(object(10), start);
    window.push(object(20), start + 50ms);
    EXPECT_EQ(times(window.take_ripe(start + 120ms)), Times{10});
    EXPECT_EQ(times(window.take_ripe(start + 150ms)), Times{20});
    EXPECT_EQ(times(window.take_ripe(start + 1h)), Times{});
}

TEST(ReorderWindow, WhatComesTooLateIsCountedAndNotLost) {
    ReorderWindow window(100ms);
    window.push(object(10), start);
    window.push(object(30), start);
    EXPECT_EQ(window.take_ripe(start + 100ms).size(), 2U);
    window.push(object(20), start + 110ms);
    EXPECT_EQ(times(window.take_ripe(start + 300ms)), Times{20});
    EXPECT_EQ(window.late(), 1U);
}

TEST(ReorderWindow, EqualTimesKeepTheirOrder) {
    ReorderWindow window(100ms);
    for (const char* label : {"A", "B", "C"}) window.push({5, label, {}}, start);
    std::string order;
    for (const QueuedObject& o : window.take_all()) order += o.label;
    EXPECT_EQ(order, "ABC");
}

TEST(ReorderWindow, KnowsHowManyBytesWait) {
    ReorderWindow window(100ms);
    window.push(object(1, 100), start);
    window.push(object(2, 50), start + 50ms);
    EXPECT_EQ(window.bytes(), 150U);
    window.take_ripe(start + 100ms);
    EXPECT_EQ(window.bytes(), 50U);
    window.take_all();
    EXPECT_EQ(window.bytes(), 0U);
}

}  // namespace
}  // namespace flownav
