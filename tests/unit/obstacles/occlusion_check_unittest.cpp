#include "flownav/obstacles/occlusion_check.h"

#include <gtest/gtest.h>

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

const Vector2d camera_m(-0.2, 0.1);

/// A patch along the line of sight at a bearing, between two distances from the camera.
GroundPatch patch(double bearing_rad, double near_m, double far_m) {
    const Vector2d along(std::cos(bearing_rad), std::sin(bearing_rad));
    return {camera_m + near_m * along, camera_m + far_m * along, 0.02};
}

ObstaclePoint point(double bearing_rad, double range_m) {
    ObstaclePoint p;
    p.position_m << camera_m + range_m * Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)), 0.3;
    return p;
}

TEST(HiddenFloor, BehindAPointThereIsNone) {
    std::vector<GroundPatch> ground = {patch(0.3, 1.1, 1.2), patch(0.3, 0.8, 0.9)};
    remove_occluded_floor({point(0.3, 1.0)}, camera_m, ground);
    ASSERT_EQ(ground.size(), 1U);
    EXPECT_NEAR((ground[0].near_m - camera_m).norm(), 0.8, 1e-9);
    EXPECT_NEAR((ground[0].far_m - camera_m).norm(), 0.9, 1e-9);
}

TEST(HiddenFloor, APatchThatReachesBehindAPointEndsAtIt) {
    std::vector<GroundPatch> ground = {patch(-1.0, 0.9, 1.3)};
    remove_occluded_floor({point(-1.0, 1.0)}, camera_m, ground);
    ASSERT_EQ(ground.size(), 1U);
    EXPECT_NEAR((ground[0].near_m - camera_m).norm(), 0.9, 1e-9);
    EXPECT_NEAR((ground[0].far_m - camera_m).norm(), 1.0, 1e-9);
}

TEST(HiddenFloor, BesideAPointItStays) {
    for (const double beside_rad : {0.05, -0.05, 1.0}) {
        std::vector<GroundPatch> ground = {patch(0.3 + beside_rad, 2.0, 2.2)};
        remove_occluded_floor({point(0.3, 1.0)}, camera_m, ground);
        EXPECT_EQ(ground.size(), 1U) << beside_rad;
    }
}

TEST(HiddenFloor, TheNearestPointCountsAlsoStraightBehindTheCamera) {
    std::vector<GroundPatch> ground = {patch(M_PI - 0.005, 1.5, 1.6)};
    remove_occluded_floor({point(-M_PI + 0.005, 1.0), point(-M_PI + 0.005, 3.0)}, camera_m, ground);
    EXPECT_TRUE(ground.empty());
}

TEST(HiddenFloor, WithoutPointsNothingIsHidden) {
    std::vector<GroundPatch> ground = {patch(0.0, 1.0, 1.1), patch(0.2, 2.0, 2.1)};
    remove_occluded_floor({}, camera_m, ground);
    EXPECT_EQ(ground.size(), 2U);
}

}  // namespace
}  // namespace flownav::obstacles
