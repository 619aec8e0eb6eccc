#include "flownav/nav/lane_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "flownav/nav/motion_model.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

LaneLayout small_layout() {
    LaneLayout layout;
    layout.map_size_m = 5.0;
    layout.lanes = 11;
    layout.length_m = 1.5;
    layout.headings = 8;
    return layout;
}

const LaneTables& tables() {
    static const LaneTables made = make_lane_tables(RobotModel(), small_layout());
    return made;
}

Vector2d middle_of(const LaneTables& of, std::uint32_t index) {
    return of.grid.middle_of(of.grid.cell_at(index));
}

/// Distance of the footprint to a point after `way_m` along a lane.
double distance_m(const LaneTables& of, const Lane& lane, double way_m, const Vector2d& point_m) {
    const Pose2 turned{0.0, 0.0, lane.heading_rad};
    const Pose2 there = compose(turned, pose_after({1.0, lane.curvature_1pm}, way_m));
    return signed_distance_m(of.robot.footprint_m, transform(inverse(there), point_m));
}

double nearest_m(const LaneTables& of, const Lane& lane, double end_m, const Vector2d& point_m) {
    double nearest = distance_m(of, lane, std::max(0.0, end_m), point_m);
    for (double way_m = 0.0; way_m <= end_m; way_m += 0.01)
        nearest = std::min(nearest, distance_m(of, lane, way_m, point_m));
    return nearest;
}

constexpr double accuracy_m = 0.008;

/// Compares a lane with the footprint moved in fine steps.
void expect_as_swept(const LaneTables& of, const Lane& lane) {
    std::map<std::uint32_t, LaneCell> cells;
    for (const LaneCell& cell : lane.cells) cells[cell.index] = cell;
    EXPECT_EQ(cells.size(), lane.cells.size());  // every cell appears once
    for (int row = 0; row < of.grid.rows; ++row) {
        for (int column = 0; column < of.grid.columns; ++column) {
            const Vector2d p = of.grid.middle_of({column, row});
            if (distance_m(of, lane, 0.0, p) < of.layout.margin_m + 0.02) continue;  // beside the robot
            const auto index = static_cast<std::uint32_t>(row * of.grid.columns + column);
            const bool touched = cells.count(index) > 0 && cells[index].gap == 0;
            const double way_m = touched ? cells[index].way * 0.001 : lane.length_m;
            const double before_m = nearest_m(of, lane, touched ? way_m - 0.03 : way_m, p);
            ASSERT_GT(before_m, of.layout.margin_m - accuracy_m) << p.transpose();
            if (touched) {
                ASSERT_LT(distance_m(of, lane, way_m, p), of.layout.margin_m + accuracy_m);
            } else if (cells.count(index) > 0) {
                ASSERT_NEAR(cells[index].gap * gap_unit_m, before_m, accuracy_m + gap_unit_m);
            } else {
                ASSERT_GT(before_m, of.layout.side_m - accuracy_m);
            }
        }
    }
}

TEST(LaneTables, AStraightLaneIsTouchedWhenTheBumperArrives) {
    const Lane& straight = tables().lanes[5];
    ASSERT_EQ(straight.curvature_1pm, 0.0);
    for (const LaneCell& cell : straight.cells) {
        const Vector2d p = middle_of(tables(), cell.index);
        if (p.x() < 0.35 || p.x() > 1.7 || std::abs(p.y()) > 0.2) continue;
        EXPECT_EQ(cell.gap, 0);
        EXPECT_NEAR(cell.way * 0.001, p.x() - 0.25 - tables().layout.margin_m, 0.03);
    }
}

TEST(LaneTables, LanesAreTheSweptFootprint) {
    for (const int i : {0, 3, 5, 9}) expect_as_swept(tables(), tables().lanes[i]);
    expect_as_swept(tables(), tables().headings[3]);
}

TEST(LaneTables, AFootprintMayHaveAnyShape) {
    RobotModel arrow;  // with a notch, and asymmetric
    arrow.footprint_m = {{0.5, 0.0}, {-0.3, 0.35}, {-0.1, 0.0}, {-0.2, -0.2}};
    const LaneTables made = make_lane_tables(arrow, small_layout());
    expect_as_swept(made, made.lanes[2]);
    expect_as_swept(made, made.lanes[9]);
}

TEST(LaneTables, CellsAreOrderedByTheWay) {
    ASSERT_FALSE(tables().lanes.empty());
    for (const Lane& lane : tables().lanes) {
        EXPECT_FALSE(lane.cells.empty());
        EXPECT_TRUE(std::is_sorted(lane.cells.begin(), lane.cells.end(),
                                   [](const LaneCell& a, const LaneCell& b) { return a.way < b.way; }));
    }
}

TEST(LaneTables, LeftAndRightAreMirrored) {
    const Lane& right = tables().lanes.front();
    const Lane& left = tables().lanes.back();
    EXPECT_LT(right.curvature_1pm, 0.0);
    EXPECT_EQ(right.curvature_1pm, -left.curvature_1pm);
    EXPECT_EQ(right.cells.size(), left.cells.size());
    double y_right = 0.0;
    double y_left = 0.0;
    for (const LaneCell& cell : right.cells) y_right += middle_of(tables(), cell.index).y();
    for (const LaneCell& cell : left.cells) y_left += middle_of(tables(), cell.index).y();
    EXPECT_LT(y_right, 0.0);
    EXPECT_NEAR(y_left, -y_right, 1e-3);
    EXPECT_NEAR(std::abs(1.0 / left.curvature_1pm), tables().layout.radius_min_m, 1e-9);
}

TEST(LaneTables, ACellBesideTheRobotOnlyCountsWhenTheRobotComesNearer) {
    // A point beside the left rear wheel: not touched on a straight lane, hit by the rear in a hard right
    // turn.
    const auto way_to = [](const Lane& lane, const Vector2d& p) -> int {
        for (const LaneCell& cell : lane.cells)
            if (cell.gap == 0 && (middle_of(tables(), cell.index) - p).norm() < 0.01) return cell.way;
        return -1;
    };
    const Vector2d beside(-0.15, 0.25);
    EXPECT_EQ(way_to(tables().lanes[5], beside), -1);
    EXPECT_GE(way_to(tables().lanes.front(), beside), 0);
    EXPECT_LT(way_to(tables().lanes.front(), beside), 200);
}

TEST(LaneTables, TurningOnTheSpotSweepsTheCircle) {
    const double radius_m = circumscribed_radius_m(tables().robot.footprint_m);
    double farthest_m = 0.0;
    for (const LaneCell& cell : tables().turn_left)
        if (cell.gap == 0) farthest_m = std::max(farthest_m, middle_of(tables(), cell.index).norm());
    EXPECT_NEAR(farthest_m, radius_m + tables().layout.tight_margin_m, 0.08);
    EXPECT_EQ(tables().turn_left.size(), tables().turn_right.size());
}

TEST(LaneTables, ALayoutThatMakesNoSenseIsRefused) {
    LaneLayout even = small_layout();
    even.lanes = 10;
    EXPECT_THROW(make_lane_tables(RobotModel(), even), std::invalid_argument);
    LaneLayout tiny = small_layout();
    tiny.map_size_m = 0.8;
    EXPECT_THROW(make_lane_tables(RobotModel(), tiny), std::invalid_argument);
    LaneLayout flat = small_layout();
    flat.radius_min_m = 0.0;
    EXPECT_THROW(make_lane_tables(RobotModel(), flat), std::invalid_argument);
    RobotModel line;
    line.footprint_m = {{0.1, 0.0}, {-0.1, 0.0}};
    EXPECT_THROW(make_lane_tables(line, small_layout()), std::invalid_argument);
}

}  // namespace
}  // namespace flownav::nav
