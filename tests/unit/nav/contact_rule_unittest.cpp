#include "local/contact_rule.h"

#include <gtest/gtest.h>

#include <limits>

namespace flownav::nav {
namespace {

constexpr ContactRule rule{0.05, 0.003, 0.06};

TEST(ContactRule, ACellIsTouchedWithinTheMargin) {
    EXPECT_TRUE(rule.touches(0.5, 0.049));
    EXPECT_FALSE(rule.touches(0.5, 0.051));
    EXPECT_TRUE(rule.touches(0.5, -0.1));
    EXPECT_TRUE(rule.touches(0.5, std::numeric_limits<double>::quiet_NaN()));
}

TEST(ContactRule, ACellBesideTheRobotIsTouchedOnlyOnceItComesNearer) {
    for (const double first_m : {0.04, 0.0, -0.05}) {
        EXPECT_FALSE(rule.touches(first_m, first_m - 0.002));
        EXPECT_TRUE(rule.touches(first_m, first_m - 0.004));
    }
}

TEST(ContactRule, ACellDeepBelowTheRobotIsIgnored) {
    EXPECT_TRUE(rule.touches(-0.059, -0.2));
    EXPECT_FALSE(rule.touches(-0.061, -0.2));
    EXPECT_FALSE(rule.is_ignored(-0.06));
    EXPECT_TRUE(rule.is_ignored(-0.061));
}

TEST(ContactRule, TheMarginShrinksToTheNearestCellButNotBelowTheLeastMargin) {
    EXPECT_DOUBLE_EQ(rule.beside(std::numeric_limits<double>::infinity()).margin_m, 0.05);
    EXPECT_DOUBLE_EQ(rule.beside(0.04).margin_m, 0.037);
    EXPECT_DOUBLE_EQ(rule.beside(-0.03).margin_m, 0.02);
    EXPECT_DOUBLE_EQ(rule.beside(0.04, 0.045).margin_m, 0.045);
}

}  // namespace
}  // namespace flownav::nav
