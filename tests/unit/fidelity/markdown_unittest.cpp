#include "markdown.h"

#include <gtest/gtest.h>

#include <limits>

namespace flownav::fidelity {
namespace {

TEST(Markdown, TableHasAHeadARuleAndItsRows) {
    EXPECT_EQ(to_markdown({{"a", "b"}, {{"x", "1"}, {"y", "2"}}}),
              "| a | b |\n|---|--:|\n| x | 1 |\n| y | 2 |\n\n");
}

TEST(Markdown, FigureStandsBesideItsTarget) {
    EXPECT_EQ(cell(0.0123, 3, below(0.025)), "0.012 < 0.025");
    EXPECT_EQ(cell(81.6, 0, above(70.0)), "82 ≥ 70");
    EXPECT_EQ(cell(1.25, 2), "1.25");
}

TEST(Markdown, MissedTargetIsBoldAndNotHidden) {
    EXPECT_EQ(cell(0.109, 3, below(0.03)), "**0.109** ≥ 0.03");
    EXPECT_EQ(cell(33.3, 0, above(70.0)), "**33** < 70");
}

TEST(Markdown, BiasCountsByItsMagnitude) {
    EXPECT_EQ(cell(-0.09, 2, below(0.2)), "-0.09 < 0.2");
    EXPECT_EQ(cell(-0.31, 2, below(0.2)).substr(0, 9), "**-0.31**");
}

TEST(Markdown, NothingMeasuredIsADash) {
    EXPECT_EQ(cell(std::numeric_limits<double>::quiet_NaN(), 2, below(1.0)), "-");
}

}  // namespace
}  // namespace flownav::fidelity
