#include "background_writer.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <vector>

namespace flownav::drive {
namespace {

TEST(BackgroundWriter, DoesItsJobsInTheirOrder) {
    std::vector<int> done;
    BackgroundWriter writer;
    for (int i = 0; i < 100; ++i) writer.push([&done, i] { done.push_back(i); });
    writer.finish();
    ASSERT_EQ(done.size(), 100U);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(BackgroundWriter, TakesNoMoreThanMayWait) {
    std::promise<void> go;
    std::promise<void> begun;
    BackgroundWriter writer;
    writer.push([&] {
        begun.set_value();
        go.get_future().wait();
    });
    begun.get_future().wait();  // the first job is running and no longer waits
    EXPECT_TRUE(writer.push_if_fewer([] {}, 2));
    EXPECT_TRUE(writer.push_if_fewer([] {}, 2));
    EXPECT_FALSE(writer.push_if_fewer([] {}, 2));
    go.set_value();
    writer.finish();
}

TEST(BackgroundWriter, OneThatMayWaitLosesNothing) {
    int done = 0;
    BackgroundWriter writer;
    for (int i = 0; i < 1000; ++i) writer.push_when_fewer([&done] { ++done; }, 3);
    writer.finish();
    EXPECT_EQ(done, 1000);
}

TEST(BackgroundWriter, AJobThatThrowsIsTheLastAndFinishTellsIt) {
    int done = 0;
    BackgroundWriter writer;
    writer.push([] { throw std::runtime_error("disk full"); });
    for (int i = 0; i < 10; ++i) writer.push_when_fewer([&done] { ++done; }, 3);
    EXPECT_THROW(writer.finish(), std::runtime_error);
    EXPECT_EQ(done, 0);
}

TEST(BackgroundWriter, WhatWaitsIsDoneBeforeItGoes) {
    int done = 0;
    {
        BackgroundWriter writer;
        for (int i = 0; i < 10; ++i) writer.push([&done] { ++done; });
    }
    EXPECT_EQ(done, 10);
}

}  // namespace
}  // namespace flownav::drive
