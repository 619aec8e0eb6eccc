#include "flownav/nav/watchdog.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <future>

namespace flownav::nav {
namespace {

constexpr double hour_s = 3600.0;

TEST(Watchdog, StopsTheRobotWhenNobodyFeedsIt) {
    std::promise<void> stopped;
    Watchdog watchdog([&] { stopped.set_value(); });
    watchdog.start_watchdog(0.001);
    EXPECT_EQ(stopped.get_future().wait_for(std::chrono::seconds(30)), std::future_status::ready);
}

TEST(Watchdog, StopsOnceForEverySilence) {
    std::mutex mutex;
    std::condition_variable stopped;
    int stops = 0;
    Watchdog watchdog([&] {
        const std::lock_guard lock(mutex);
        ++stops;
        stopped.notify_all();
    });
    watchdog.start_watchdog(0.001);
    for (int silence = 1; silence <= 3; ++silence) {
        std::unique_lock lock(mutex);
        ASSERT_TRUE(stopped.wait_for(lock, std::chrono::seconds(30), [&] { return stops == silence; }));
        lock.unlock();
        watchdog.alive();
    }
}

TEST(Watchdog, LeavesAloneWhoFeedsItInTime) {
    std::atomic<int> stops = 0;
    {
        Watchdog watchdog([&] { ++stops; });
        watchdog.start_watchdog(hour_s);
        for (int i = 0; i < 1000; ++i) watchdog.alive();
    }
    EXPECT_EQ(stops, 0);
}

TEST(Watchdog, SleepsUntilItIsStartedAndAfterItIsStopped) {
    std::atomic<int> stops = 0;
    {
        Watchdog watchdog([&] { ++stops; });
        watchdog.alive();
        watchdog.start_watchdog(hour_s);
        watchdog.stop_watchdog();
        watchdog.alive();
    }
    EXPECT_EQ(stops, 0);
}

TEST(Watchdog, APeriodThatIsNoTimeIsRefused) {
    Watchdog watchdog([] {});
    EXPECT_THROW(watchdog.start_watchdog(-1.0), std::invalid_argument);
    EXPECT_THROW(watchdog.start_watchdog(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace flownav::nav
