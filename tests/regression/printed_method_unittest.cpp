#include <gtest/gtest.h>

#include <cmath>

#include "drives.h"

namespace flownav {
namespace {

/// Mean error of the measured speeds of a rendered drive of 0.4 m/s, percent.
double v_bias_percent(const std::vector<Field>& fields, const pipeline::Params& params) {
    double sum_percent = 0.0;
    int cycles = 0;
    for (const pipeline::Step& step : testing::run(fields, params)) {
        if (!step.v_measured) continue;
        sum_percent += 100.0 * (step.v_mps / 0.4 - 1.0);
        ++cycles;
    }
    EXPECT_GE(cycles, 5);
    return sum_percent / cycles;
}

TEST(HonestyOfThePrintedMethod, ItsSpeedIsSeveralPercentTooHighAndOursIsNot) {
    testing::DriveOptions options;
    options.images = 25;
    const std::vector<Field> fields = render_fields(testing::drive(options));
    const pipeline::Params ours = testing::cycles_of(4);
    pipeline::Params printed = ours;
    printed.motion.geometry = Geometry::Block;
    printed.flow.subpixel = flow::Subpixel::None;
    const double printed_percent = v_bias_percent(fields, printed);
    EXPECT_GT(printed_percent, 3.0);
    EXPECT_LT(printed_percent, 8.0);
    EXPECT_LT(std::abs(v_bias_percent(fields, ours)), 0.5);
}

}  // namespace
}  // namespace flownav
