#include "flownav/report/drive_picture.h"

#include <gtest/gtest.h>

#include "flownav/report/palette.h"

namespace flownav::report {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

/// From (0, 0) to (4, 0) m; with the margin the picture shows x -3 .. 7 m and y -3 .. 3 m, 100 px a metre.
DriveScene scene_of_four_metres() {
    DriveScene scene;
    scene.footprint_m = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
    scene.goals_m = {{4.0, 0.0}};
    scene.goal_radius_m = 0.5;
    return scene;
}

cv::Vec3b at(const cv::Mat& picture, double x_m, double y_m) {
    return picture.at<cv::Vec3b>(cvFloor(100 * (3.0 - y_m)), cvFloor(100 * (x_m + 3.0)));
}

TEST(DrivePicture, StandsInMetresWithTheMapBelow) {
    Grid grid(-2, 2, -2, 2, 0.1F);
    grid.setCell(grid.x2idx(-1.05F), grid.y2idx(1.25F), 0.0F);
    const cv::Mat picture = drive_picture(scene_of_four_metres(), grid);
    EXPECT_EQ(picture.size(), cv::Size(1000, 600));
    EXPECT_LT(at(picture, -1.05, 1.25)[0], 10);
    EXPECT_EQ(at(picture, -1.05, 1.15), cv::Vec3b(128, 128, 128)) << "unknown, in the map";
    EXPECT_EQ(at(picture, 6.0, 2.0), cv::Vec3b(128, 128, 128)) << "outside of the map";
    EXPECT_EQ(at(picture, 4.5, 0.0), palette::green.bgr()) << "the goal's circle";
    EXPECT_NE(at(picture, -0.2, 0.1), palette::blue.bgr()) << "no way, no robot";
}

TEST(DrivePicture, ShowsWaysOutlinesAndContact) {
    DriveScene scene = scene_of_four_metres();
    scene.believed = {{0, 0, 0}, {2, 1, 0}};
    scene.true_way = {{0, 0, 0}, {2, -1, 0}};
    scene.end = scene.true_way.back();
    scene.outlines_m = {{{1.0, 1.5}, {1.5, 1.5}, {1.5, 2.0}, {1.0, 2.0}}};
    const cv::Mat way = drive_picture(scene, Grid(-2, 2, -2, 2, 0.1F));
    EXPECT_EQ(at(way, -0.2, 0.1), palette::blue.bgr()) << "the robot at the start";
    EXPECT_EQ(at(way, 2.2, -1.1), palette::blue.bgr()) << "the robot at the end";
    EXPECT_NE(at(way, 1.0, 1.75), cv::Vec3b(128, 128, 128)) << "an outline";
    scene.touched = true;
    EXPECT_EQ(at(drive_picture(scene, Grid(-2, 2, -2, 2, 0.1F)), 2.2, -1.1), palette::vermilion.bgr());
}

TEST(DrivePicture, WithoutTheTruthTheBelievedWayCounts) {
    DriveScene scene = scene_of_four_metres();
    scene.believed = {{0, 0, 0}, {2, -1, 0}};
    scene.end = scene.believed.back();
    const cv::Mat picture = drive_picture(scene, Grid(-2, 2, -2, 2, 0.1F));
    EXPECT_EQ(at(picture, 2.2, -1.1), palette::orange.bgr()) << "the robot at the end";
}

}  // namespace
}  // namespace flownav::report
