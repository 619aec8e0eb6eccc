#include "flownav/sim/timed_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace flownav::sim {
namespace {

std::filesystem::path file_with(const std::string& name, const std::string& text) {
    std::filesystem::path file =
        std::filesystem::path(::testing::TempDir()) / ("timed_path_" + name + ".csv");
    std::ofstream(file) << text;
    return file;
}

std::string complaint(const std::string& name, const std::string& text) {
    try {
        read_path(file_with(name, text), std::nullopt);
    } catch (const PathError& error) {
        return error.what();
    }
    return "";
}

TEST(TimedPath, RestsBeforeTheFirstPointAndAfterTheLast) {
    const TimedPath path({{1.0, {1.0, 0.0, 0.0}}, {2.0, {2.0, 0.0, 0.0}}});
    EXPECT_EQ(path.at(0.0).x_m, 1.0);
    EXPECT_EQ(path.at(9.0).x_m, 2.0);
    EXPECT_NEAR(path.at(1.25).x_m, 1.25, 1e-12);
}

TEST(TimedPath, GoesAlongAnArcBetweenTwoPoints) {
    const TimedPath path({{0.0, {}}, {1.0, {2.0, 2.0, M_PI / 2}}});
    EXPECT_NEAR(path.at(0.5).x_m, 2.0 * std::sin(M_PI / 4), 1e-12);
    EXPECT_NEAR(path.at(0.5).y_m, 2.0 - 2.0 * std::cos(M_PI / 4), 1e-12);
    EXPECT_NEAR(path.at(0.5).yaw_rad, M_PI / 4, 1e-12);
}

TEST(TimedPath, GoesBackwardAndTurnsOnTheSpot) {
    const TimedPath path({{0.0, {}}, {1.0, {-1.0, 0.0, 0.0}}, {2.0, {-1.0, 0.0, -1.0}}});
    EXPECT_NEAR(path.at(0.5).x_m, -0.5, 1e-12);
    EXPECT_NEAR(path.at(0.5).yaw_rad, 0.0, 1e-12);
    EXPECT_NEAR(path.at(1.5).x_m, -1.0, 1e-12);
    EXPECT_NEAR(path.at(1.5).yaw_rad, -0.5, 1e-12);
}

TEST(TimedPath, RefusesTimesThatDoNotGrowAndWhatIsNoNumber) {
    EXPECT_THROW(TimedPath(std::vector<PathPoint>{}), PathError);
    EXPECT_THROW(TimedPath({{1.0, {}}, {1.0, {}}}), PathError);
    const PathPoint nowhere{0.0, {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}};
    EXPECT_THROW(TimedPath(std::vector<PathPoint>{nowhere}), PathError);
}

TEST(ReadPath, TakesColumnsInAnyOrderAndCountsTimesFromTheFirst) {
    const auto file = file_with("order", "yaw_rad,x_m,note,time_s,y_m\r\n0,1,a,100.5,2\n\n0,2,b,101.5,2\n");
    const TimedPath path = read_path(file, std::nullopt);
    EXPECT_EQ(path.end_s(), 1.0);
    EXPECT_NEAR(path.at(0.5).x_m, 1.5, 1e-12);
    EXPECT_NEAR(path.at(0.5).y_m, 2.0, 1e-12);
}

TEST(ReadPath, SkipsAByteOrderMark) {
    const auto file = file_with("mark", "\xEF\xBB\xBFtime_s,x_m,y_m,yaw_rad\r\n0,1,2,0\r\n1,2,2,0\r\n");
    EXPECT_NEAR(read_path(file, std::nullopt).at(0.5).x_m, 1.5, 1e-12);
}

TEST(ReadPath, KeepsTheSpeedWhereThereAreNoTimes) {
    const auto file =
        file_with("speed", "x_m,y_m,yaw_rad\n0,0,0\n1,0,0\n1,0,0\n1,0,1\n2,1,2.5707963267948966\n");
    const TimedPath path = read_path(file, PathSpeed{0.5, 0.25});
    EXPECT_NEAR(path.at(1.0).x_m, 0.5, 1e-12);
    EXPECT_NEAR(path.at(2.0 + 4.0).yaw_rad, 1.0, 1e-9);
    // The curve limits the speed to less than 0.5 m/s.
    EXPECT_NEAR(path.end_s(), 2.0 + 4.0 + M_PI / 2 / 0.25, 1e-9);
}

TEST(ReadPath, SaysFileAndLineOfWhatGoesWrong) {
    EXPECT_NE(complaint("header", "x_m,y_m\n0,0\n").find("yaw_rad is missing"), std::string::npos);
    EXPECT_NE(complaint("number", "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n1,zero,0,0\n")
                  .find("number.csv:3: \"zero\" is not a"),
              std::string::npos);
    EXPECT_NE(complaint("few", "time_s,x_m,y_m,yaw_rad\n0,0,0\n").find("few.csv:2: too few"),
              std::string::npos);
    EXPECT_NE(complaint("later", "time_s,x_m,y_m,yaw_rad\n0,0,0,0\n0,1,0,0\n").find("later.csv:3: time_s"),
              std::string::npos);
    EXPECT_NE(complaint("empty", "time_s,x_m,y_m,yaw_rad\n").find("no point"), std::string::npos);
    EXPECT_NE(complaint("untimed", "x_m,y_m,yaw_rad\n0,0,0\n").find("a speed must be given"),
              std::string::npos);
    EXPECT_THROW(read_path("/no/such/file.csv", std::nullopt), PathError);
    EXPECT_THROW(read_path(::testing::TempDir(), std::nullopt), PathError);
}

}  // namespace
}  // namespace flownav::sim
