#include "flownav/obstacles/virtual_scan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"
#include "flownav/testing/camera.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

VirtualScan empty_scan() {
    return scan_layout(RayMapper(testing::standard_camera()), {});
}

int beam_at(const VirtualScan& scan, double bearing_deg) {
    return static_cast<int>(std::lround((bearing_deg * degree_rad - scan.first_bearing_rad) / scan.step_rad));
}

Vector2d polar(double range_m, double bearing_deg) {
    return range_m * Vector2d(std::cos(bearing_deg * degree_rad), std::sin(bearing_deg * degree_rad));
}

ObstaclePoint point(double range_m, double bearing_deg) {
    ObstaclePoint p;
    p.position_m << polar(range_m, bearing_deg), 0.4;
    return p;
}

GroundPatch patch(double near_m, double far_m, double bearing_deg) {
    return {polar(near_m, bearing_deg), polar(far_m, bearing_deg)};
}

Beam beam_of(const std::vector<ObstaclePoint>& points, std::vector<GroundPatch> patches, double bearing_deg) {
    VirtualScan scan = empty_scan();
    fill_scan(scan, points, patches);
    return scan.beams.at(static_cast<std::size_t>(beam_at(scan, bearing_deg)));
}

void expect_all_unknown(const VirtualScan& scan) {
    ASSERT_FALSE(scan.beams.empty());
    for (const Beam& beam : scan.beams) EXPECT_EQ(beam.kind, BeamKind::Unknown);
}

TEST(VirtualScan, CoversTheViewOfTheCameraEvenlyToBothSides) {
    const VirtualScan scan = empty_scan();
    EXPECT_NEAR(scan.step_rad, 2.0 * degree_rad, 1e-12);
    const double last = scan.first_bearing_rad + static_cast<double>(scan.beams.size() - 1) * scan.step_rad;
    EXPECT_NEAR(last, -scan.first_bearing_rad, 1e-12);
    EXPECT_GT(last, 27.5 * degree_rad);  // wider than the camera, which looks down
    EXPECT_LT(last, 45.0 * degree_rad);
}

TEST(VirtualScan, NothingSeenIsUnknownNotFree) {
    VirtualScan scan = empty_scan();
    std::vector<GroundPatch> none;
    fill_scan(scan, {}, none);
    expect_all_unknown(scan);
}

TEST(VirtualScan, BlindBeamsStayUnknownBesideAnObstacle) {
    const std::vector<ObstaclePoint> points = {point(2.0, 10.0)};
    EXPECT_EQ(beam_of(points, {}, 10.0).kind, BeamKind::Obstacle);
    EXPECT_EQ(beam_of(points, {}, 14.0).kind, BeamKind::Unknown);
    EXPECT_EQ(beam_of(points, {}, -10.0).kind, BeamKind::Unknown);
}

TEST(VirtualScan, LeftIsAPositiveBearing) {
    VirtualScan scan = empty_scan();
    std::vector<GroundPatch> none;
    ObstaclePoint left;
    left.position_m = {2.0, 0.5, 0.3};
    fill_scan(scan, {left}, none);
    for (std::size_t i = 0; i < scan.beams.size() / 2; ++i) EXPECT_EQ(scan.beams[i].kind, BeamKind::Unknown);
    EXPECT_EQ(scan.beams.at(static_cast<std::size_t>(beam_at(scan, 14.0))).kind, BeamKind::Obstacle);
}

TEST(VirtualScan, TheNearestObstacleOfABeamCounts) {
    for (const auto& points : {std::vector<ObstaclePoint>{point(3, 0), point(2, 0.5), point(4, -0.5)},
                               std::vector<ObstaclePoint>{point(2, 0), point(3, 0.5)}}) {
        const Beam beam = beam_of(points, {}, 0.0);
        EXPECT_EQ(beam.kind, BeamKind::Obstacle);
        EXPECT_NEAR(beam.range_m, 2.0, 1e-12);
    }
}

TEST(VirtualScan, ConfirmedFloorWithoutGapIsFree) {
    const Beam beam = beam_of({}, {patch(2.0, 2.6, 0), patch(1.0, 1.3, 0), patch(1.6, 1.9, 0)}, 0.0);
    EXPECT_EQ(beam.kind, BeamKind::Free);
    EXPECT_NEAR(beam.range_m, 2.6, 1e-12);
}

TEST(VirtualScan, AGapOfMoreThanHalfAMetreEndsTheFreeFloor) {
    const Beam beam = beam_of({}, {patch(1.0, 1.3, 0), patch(1.9, 2.6, 0), patch(2.0, 3.0, 0)}, 0.0);
    EXPECT_EQ(beam.kind, BeamKind::Free);
    EXPECT_NEAR(beam.range_m, 1.3, 1e-12);
}

TEST(VirtualScan, FloorBehindAnObstacleDoesNotFreeTheBeam) {
    const Beam beam = beam_of({point(2.0, 0)}, {patch(1.0, 1.4, 0), patch(2.2, 2.6, 0)}, 0.0);
    EXPECT_EQ(beam.kind, BeamKind::Obstacle);
    EXPECT_NEAR(beam.range_m, 2.0, 1e-12);
}

TEST(VirtualScan, IsFilledAnewEveryTime) {
    VirtualScan scan = empty_scan();
    std::vector<GroundPatch> patches;
    fill_scan(scan, {point(2.0, 0)}, patches);
    EXPECT_EQ(scan.beams.at(static_cast<std::size_t>(beam_at(scan, 0.0))).kind, BeamKind::Obstacle);
    fill_scan(scan, {}, patches);
    expect_all_unknown(scan);
}

TEST(VirtualScan, WhatLiesOutsideTheViewIsLeftOut) {
    VirtualScan scan = empty_scan();
    std::vector<GroundPatch> patches = {patch(1, 2, 120)};
    fill_scan(scan, {point(2.0, -90), point(2.0, 180)}, patches);
    expect_all_unknown(scan);
}

}  // namespace
}  // namespace flownav::obstacles
