#include "flownav/nav/guard_reason.h"

#include <gtest/gtest.h>

namespace flownav::nav {
namespace {

TEST(GuardReason, ASensorThatCannotBeReliedOnIsAFaultOfSensingAndAnObstacleIsNone) {
    for (const GuardReason reason :
         {GuardReason::OdometryContradiction, GuardReason::SensorFrozen, GuardReason::OmegaLost,
          GuardReason::SensorBlind, GuardReason::SensorStale})
        EXPECT_TRUE(is_fault_of_sensing(reason)) << to_string(reason);
    for (const GuardReason reason :
         {GuardReason::None, GuardReason::UnseenAhead, GuardReason::UnconfirmedAhead,
          GuardReason::ObstacleAhead, GuardReason::NavigatorSilent})
        EXPECT_FALSE(is_fault_of_sensing(reason)) << to_string(reason);
}

TEST(GuardReason, ASilentNavigatorIsGraverThanAnObstacleAndThatThanUnseenGround) {
    EXPECT_GT(gravity(GuardReason::NavigatorSilent), gravity(GuardReason::SensorStale));
    EXPECT_GT(gravity(GuardReason::SensorBlind), gravity(GuardReason::OmegaLost));
    EXPECT_GT(gravity(GuardReason::OmegaLost), gravity(GuardReason::ObstacleAhead));
    EXPECT_GT(gravity(GuardReason::ObstacleAhead), gravity(GuardReason::UnconfirmedAhead));
    EXPECT_GT(gravity(GuardReason::UnconfirmedAhead), gravity(GuardReason::UnseenAhead));
    EXPECT_GT(gravity(GuardReason::UnseenAhead), gravity(GuardReason::None));
    EXPECT_EQ(gravity(GuardReason::None), 0);
}

TEST(GuardReason, StoppingIsGraverThanSlowing) {
    EXPECT_GT(gravity(GuardAction::Stop), gravity(GuardAction::Slow));
    EXPECT_GT(gravity(GuardAction::Slow), gravity(GuardAction::Pass));
}

}  // namespace
}  // namespace flownav::nav
