#include "flownav/nav/base_protocol.h"

#include <gtest/gtest.h>

namespace flownav::nav {
namespace {

using namespace base_protocol;

template <typename Kind>
Kind parsed(const std::string& text) {
    LineBuffer lines;
    lines.add(text);
    const Line line = parse(lines.next().value());
    EXPECT_TRUE(std::holds_alternative<Kind>(line)) << text;
    return std::holds_alternative<Kind>(line) ? std::get<Kind>(line) : Kind{};
}

TEST(BaseProtocol, EveryLineReadsBackAsItWasWritten) {
    const auto odometry =
        parsed<WheelReading>(text(WheelReading{1e9 + 1.0 / 3.0, {-1.5, 2e-9, 0.1}, {0.25, -3.0}}));
    EXPECT_EQ(odometry.time_s, 1e9 + 1.0 / 3.0);
    EXPECT_EQ(odometry.T_odom_robot.x_m, -1.5);
    EXPECT_EQ(odometry.T_odom_robot.y_m, 2e-9);
    EXPECT_EQ(odometry.T_odom_robot.yaw_rad, 0.1);
    EXPECT_EQ(odometry.motion.v_mps, 0.25);
    EXPECT_EQ(odometry.motion.omega_radps, -3.0);
    const auto drive = parsed<Drive>(text(Drive{{0.4, -0.9}, 77}));
    EXPECT_EQ(drive.command.v_mps, 0.4);
    EXPECT_EQ(drive.command.omega_radps, -0.9);
    EXPECT_EQ(drive.sequence, 77);
    EXPECT_EQ(parsed<Hello>(text(Hello{1, 300})).timeout_ms, 300);
    EXPECT_EQ(parsed<Hello>(text(Hello{1, 0})).timeout_ms, 0);
    EXPECT_EQ(parsed<Complaint>(text(Complaint{"no such"})).text, "no such");
    parsed<Stopped>(text(Stopped{}));
    parsed<Bye>(text(Bye{}));
}

TEST(BaseProtocol, BlanksAndCarriageReturnsDoNoHarm) {
    EXPECT_EQ(parsed<Drive>("  drive\t0.1   0 3 \r\n").sequence, 3);
}

TEST(BaseProtocol, WhatCannotBeReadIsMalformedAndSaysWhatWasExpected) {
    for (const std::string line :
         {"", "drive", "drive 1 2", "drive 1 2 x", "drive 1 2 3 4", "drive nan 0 1", "drive inf 0 1",
          "drive 0,4 0 1", "odometry 1 2 3 4 5", "odometry 1 2 3 4 5 6 7", "odometry 1 2 3 4 5 1e999",
          "hello", "hello world 1", "hello flownav-base", "hello flownav-base 1 -5", "stopped now", "go 1 2",
          "\xff\x00\x01"}) {
        const Line parsed_line = parse(line);
        ASSERT_TRUE(std::holds_alternative<Malformed>(parsed_line)) << line;
        EXPECT_FALSE(std::get<Malformed>(parsed_line).why.empty());
    }
    EXPECT_TRUE(std::holds_alternative<Malformed>(parse("error " + std::string(500, 'x'))));
}

TEST(LineBuffer, HalfLinesWaitForTheirOtherHalf) {
    LineBuffer lines;
    lines.add("drive 0.1");
    EXPECT_FALSE(lines.next());
    lines.add(" 0 1\nbye\nsto");
    EXPECT_EQ(lines.next(), "drive 0.1 0 1");
    EXPECT_EQ(lines.next(), "bye");
    EXPECT_FALSE(lines.next());
    lines.add(std::string(300, 'x'));
    EXPECT_TRUE(lines.is_overlong());
}

}  // namespace
}  // namespace flownav::nav
