#include "flownav/report/map_window.h"

#include <gtest/gtest.h>

#include "flownav/report/palette.h"

namespace flownav::report {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

constexpr int size_px = 400;
constexpr double size_m = 4.0;  // 100 pixels per metre
const cv::Vec3b vermilion(0, 94, 213);
const cv::Vec3b blue(178, 114, 0);

cv::Vec3b at(const cv::Mat& picture, double right_m, double up_m) {
    return picture.at<cv::Vec3b>(cvFloor(200 - 100 * up_m), cvFloor(200 + 100 * right_m));
}

TEST(MapWindow, ShowsXToTheRightAndYUpAroundTheRobot) {
    const Pose2 robot = {3.0, -2.0, 0.7};
    const cv::Mat picture =
        map_window(Grid(-1, 1, -1, 1, 0.1F), {{robot}, {{3.5, -2.0}, {3.0, -1.0}}, {}}, size_m, size_px);
    EXPECT_EQ(at(picture, 0.5, 0.0), vermilion);
    EXPECT_EQ(at(picture, 0.0, 1.0), vermilion);
    EXPECT_EQ(at(picture, 0.0, -1.0), cv::Vec3b(128, 128, 128)) << "unknown";
}

TEST(MapWindow, CellsStandWhereTheGridHasThem) {
    Grid grid(-2, 2, -2, 2, 0.1F);
    grid.setCell(grid.x2idx(1.25F), grid.y2idx(0.45F), 0.0F);
    grid.setCell(grid.x2idx(1.05F), grid.y2idx(0.45F), 1.0F);
    const Pose2 robot = {0.03, -0.02, 0.0};
    const cv::Mat picture = map_window(grid, {{robot}, {}, {}}, size_m, size_px);
    for (const double right_m : {1.205, 1.295}) {
        for (const double up_m : {0.405, 0.495}) {
            EXPECT_LT(at(picture, right_m - robot.x_m, up_m - robot.y_m)[0], 10) << right_m << ' ' << up_m;
        }
    }
    EXPECT_GT(at(picture, 1.05 - robot.x_m, 0.45 - robot.y_m)[0], 245) << "free";
    EXPECT_EQ(at(picture, 1.15 - robot.x_m, 0.45 - robot.y_m)[0], 128) << "unknown between them";
}

TEST(MapWindow, AContactIsALineInTheColourOfItsCause) {
    const ContactSegment wall = {{1.0, -0.5}, {1.0, 0.5}, {0.9, 0.0}, {1.1, 0.0}, BeamCause::Wall};
    const cv::Mat picture = map_window(Grid(-1, 1, -1, 1, 0.1F), {{Pose2{}}, {}, {wall}}, size_m, size_px);
    for (const double y_m : {-0.45, -0.2, 0.2, 0.45})
        EXPECT_EQ(at(picture, 1.0, y_m), palette::sky_blue.bgr()) << y_m;
    EXPECT_EQ(at(picture, 1.0, 0.6), cv::Vec3b(128, 128, 128)) << "beside its end";
    EXPECT_EQ(at(picture, -1.0, 0.2), cv::Vec3b(128, 128, 128)) << "behind the robot";
}

TEST(MapWindow, ThePathLeadsToTheRobot) {
    const cv::Mat picture =
        map_window(Grid(-1, 1, -1, 1, 0.1F), {{{0, 0, 0}, {1.5, 0, 0}}, {}, {}}, size_m, size_px);
    EXPECT_EQ(at(picture, -1.0, 0.0), blue) << "behind the robot, which stands in the middle";
    EXPECT_NE(at(picture, 1.0, 0.0), blue);
}

}  // namespace
}  // namespace flownav::report
