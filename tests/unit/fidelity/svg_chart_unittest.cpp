#include "svg_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace flownav {
namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(SvgChart, ThinningKeepsTheEndsAndEverySpike) {
    std::vector<Eigen::Vector2d> piece;
    piece.reserve(10000);
    for (int i = 0; i < 10000; ++i) piece.emplace_back(i, i == 4321 ? 100.0 : 0.0);
    const auto few = thinned(piece, 200);
    EXPECT_LE(few.size(), 200U);
    EXPECT_EQ(few.front(), piece.front());
    EXPECT_EQ(few.back(), piece.back());
    EXPECT_EQ(std::count(few.begin(), few.end(), piece[4321]), 1);
    EXPECT_TRUE(std::is_sorted(few.begin(), few.end(), [](auto& a, auto& b) { return a.x() < b.x(); }));
    EXPECT_EQ(thinned(piece, 20000).size(), piece.size());
}

TEST(SvgChart, ConstantAndSingleValuesAreDrawn) {
    Chart chart;
    chart.series = {{"one", report::palette::black, {{{1.0, 5.0}}}, false, 1.8}};
    EXPECT_TRUE(has(svg_chart(chart), "<circle"));
    EXPECT_FALSE(has(svg_chart(chart), "nan"));
    chart.series.front().pieces.clear();
    EXPECT_TRUE(has(svg_chart(chart), "no data"));
}

}  // namespace
}  // namespace flownav
