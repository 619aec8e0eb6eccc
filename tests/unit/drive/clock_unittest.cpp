#include "flownav/drive/clock.h"

#include <gtest/gtest.h>

namespace flownav::drive {
namespace {

TEST(SteadyClock, ShowsTheTimeOfTheSystemAndRises) {
    const SteadyClock clock;
    EXPECT_NEAR(clock.now_s(), system_time_s(), 0.5);
    const double before_s = clock.now_s();
    EXPECT_GE(clock.now_s(), before_s);
}

TEST(SteadyClock, WaitsUntilATimeAndNotForOneThatIsOver) {
    SteadyClock clock;
    const double until_s = clock.now_s() + 0.02;
    clock.wait_until_s(until_s);
    EXPECT_GE(clock.now_s(), until_s - 1e-6);
    const double now_s = clock.now_s();
    clock.wait_until_s(now_s - 1000.0);
    EXPECT_LT(clock.now_s() - now_s, 10.0);
}

TEST(SteadyClock, TheAgeOfAStampIsTheSameByBothClocks) {
    const SteadyClock clock;
    EXPECT_NEAR(clock.from_system_s(system_time_s() - 2.5), clock.now_s() - 2.5, 0.5);
}

}  // namespace
}  // namespace flownav::drive
