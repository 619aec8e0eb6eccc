#include "flownav/obstacles/occlusion_check.h"

#include <gtest/gtest.h>

#include "flownav/testing/contact_scans.h"

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

/// A scan with one obstacle 0.1 wide in tangent, 1 m before the camera, to the right when `tangent` is > 0.
ContactScan scan_with(double tangent, BeamCause cause = BeamCause::Votes) {
    ContactScan scan = testing::open_scan();
    scan.camera_m = camera_m;
    testing::block(scan, tangent - 0.05, tangent + 0.05, 1.0, cause);
    return scan;
}

TEST(HiddenFloor, BehindAContactThereIsNone) {
    for (const BeamCause cause : {BeamCause::Votes, BeamCause::Wall, BeamCause::Drop}) {
        std::vector<GroundPatch> ground = {patch(0.0, 1.5, 1.6), patch(0.0, 0.9, 1.2), patch(0.0, 0.5, 0.6)};
        remove_floor_behind_contacts(scan_with(0.0, cause), camera_m, ground);
        ASSERT_EQ(ground.size(), 2U);
        const double begin_m = cause == BeamCause::Drop ? 1.0 : 1.1;
        EXPECT_NEAR((ground[0].far_m - camera_m).norm(), begin_m, 2e-3);
        EXPECT_NEAR((ground[1].far_m - camera_m).norm(), 0.6, 1e-9);
    }
}

TEST(HiddenFloor, AContactToTheRightHidesFloorToTheRightOnly) {
    for (const double side : {1.0, -1.0}) {
        std::vector<GroundPatch> ground = {patch(-0.4 * side, 1.5, 1.6), patch(0.4 * side, 1.5, 1.6)};
        remove_floor_behind_contacts(scan_with(side * std::tan(0.4)), camera_m, ground);
        ASSERT_EQ(ground.size(), 1U);
        EXPECT_EQ(std::signbit(ground[0].near_m.y() - camera_m.y()), side < 0.0);
    }
}

TEST(HiddenFloor, AContactHidesFloorOverTheWholeWidthOfItsStripsAndNotFarBeside) {
    for (const double tangent : {-0.07, -0.03, 0.03, 0.07, -0.12, 0.12}) {
        std::vector<GroundPatch> ground = {patch(-std::atan(tangent), 1.5, 1.6)};
        remove_floor_behind_contacts(scan_with(0.0), camera_m, ground);
        EXPECT_EQ(ground.empty(), std::abs(tangent) < 0.1) << tangent;
    }
}

TEST(HiddenFloor, TheContactsOfAnEarlierScanStandWhereTheyStood) {
    ContactScan scan = scan_with(0.0);
    scan.T_robot_scan = {-0.3, 0.0, 0.0};  // the robot has driven 0.3 m since
    std::vector<GroundPatch> ground = {patch(0.0, 0.8, 0.9), patch(0.0, 0.5, 0.6)};
    remove_floor_behind_contacts(scan, camera_m, ground);
    EXPECT_EQ(ground.size(), 1U);
    scan.T_robot_scan = {-1.3, 0.0, 0.0};
    ground = {patch(0.0, 0.8, 0.9), patch(M_PI - 0.01, 0.8, 0.9)};
    remove_floor_behind_contacts(scan, camera_m, ground);
    EXPECT_EQ(ground.size(), 2U) << "the camera has passed the contact";
}

TEST(HiddenFloor, FreeAndUnknownStripsHideNothing) {
    std::vector<GroundPatch> ground = {patch(0.0, 2.5, 2.6)};
    remove_floor_behind_contacts(testing::free_scan(1.0), camera_m, ground);
    remove_floor_behind_contacts(testing::open_scan(), camera_m, ground);
    remove_floor_behind_contacts(ContactScan{}, camera_m, ground);
    EXPECT_EQ(ground.size(), 1U);
}

}  // namespace
}  // namespace flownav::obstacles
