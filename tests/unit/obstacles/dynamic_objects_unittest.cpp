#include "flownav/obstacles/dynamic_objects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

/// Blocks on a grid, each a neighbour of the four beside it.
struct Grid {
    int columns = 10;
    int rows = 10;
    std::vector<Classification> judgements;
    std::vector<std::array<int, 4>> neighbours;
    DynamicRegions regions;

    Grid() : judgements(100), neighbours(100) {
        for (int i = 0; i < 100; ++i) {
            const int x = i % columns;
            const int y = i / columns;
            neighbours[i] = {x > 0 ? i - 1 : -1, x < 9 ? i + 1 : -1, y > 0 ? i - 10 : -1,
                             y < 9 ? i + 10 : -1};
            judgements[i].label = BlockLabel::Ground;
            judgements[i].drift = {0.0, 0.02};
            judgements[i].drift_sigma = 1e-4;
            judgements[i].measured = true;
        }
    }
    /// Marks a rectangle of vectors as eliminated by (11), with a common drift to the right.
    void move(int x0, int y0, int x1, int y1, double drift = 0.03) {
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) {
                judgements[y * columns + x].label = BlockLabel::Eliminated;
                judgements[y * columns + x].drift = {drift, 0.02};
                judgements[y * columns + x].across_px = 5.0;
            }
        }
    }
    int moving() {
        mark_dynamic_objects(judgements, neighbours, regions);
        int count = 0;
        for (const Classification& j : judgements) count += j.label == BlockLabel::Moving;
        return count;
    }
};

TEST(Movers, AWorldAtRestHasNone) {
    Grid grid;
    EXPECT_EQ(grid.moving(), 0);
    EXPECT_EQ(grid.regions.regions, 0);
}

TEST(Movers, VectorsThatDriftAlikeAgainstTheMotionAreOneMover) {
    Grid grid;
    grid.move(2, 2, 6, 6);
    EXPECT_EQ(grid.moving(), 16);
    EXPECT_EQ(grid.regions.regions, 1);
}

TEST(Movers, TwoThatDriftDifferentlyAreTwo) {
    Grid grid;
    grid.move(0, 2, 4, 6, 0.03);
    grid.move(4, 2, 8, 6, -0.03);
    EXPECT_EQ(grid.moving(), 32);
    EXPECT_EQ(grid.regions.regions, 2);
}

TEST(Movers, ABlockAmongThemThatPassedByChanceBelongsToThem) {
    Grid grid;
    grid.move(2, 2, 6, 6);
    grid.judgements[33].label = BlockLabel::Obstacle;
    EXPECT_EQ(grid.moving(), 16);
}

TEST(Movers, AStandingObstacleBesideThemDoesNot) {
    Grid grid;
    grid.move(2, 2, 6, 6);
    grid.judgements[36].label = BlockLabel::Obstacle;  // its drift is that of the static world
    grid.moving();
    EXPECT_EQ(grid.judgements[36].label, BlockLabel::Obstacle);
}

TEST(Movers, EliminatedVectorsWithoutACommonDriftAreNone) {
    Grid grid;
    grid.move(2, 2, 8, 8);
    for (int i = 0; i < 100; ++i) grid.judgements[i].drift.x() *= (i % 2 == 0 ? 1.0 : -1.0) * (1 + i % 3);
    EXPECT_EQ(grid.moving(), 0);
}

TEST(Movers, AHandfulIsNone) {
    Grid grid;
    grid.move(2, 2, 4, 4);
    EXPECT_EQ(grid.moving(), 0);
}

/// A camera 0.9 m high, 25 degrees down, 640 x 480.
RayMapper mapper() {
    CameraModel c;
    c.width_px = 640;
    c.height_px = 480;
    c.fx_px = c.fy_px = 615.0;
    c.cx_px = 319.5;
    c.cy_px = 239.5;
    c.mount.height_m = 0.9;
    c.mount.pitch_rad = 25 * degree_rad;
    return RayMapper(c);
}

TEST(GroundContact, OfTheImageCentreIsWhereTheOpticalAxisMeetsTheFloor) {
    const auto contact = ground_contact({319.5, 239.5}, mapper());
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->forward_m, 0.9 / std::tan(25 * degree_rad), 1e-6);
    EXPECT_GT(contact->sigma_m, 0.0);
    EXPECT_LT(contact->sigma_m, 0.1);
}

TEST(GroundContact, IsUnknownWhereTheMoverLeavesTheImageBelowOrStandsOverTheHorizon) {
    EXPECT_FALSE(ground_contact({319.5, 478.0}, mapper()));
    EXPECT_FALSE(ground_contact({319.5, -45.0}, mapper()));
}

TEST(MovingPoint, StandsUprightAboveItsContact) {
    const GroundContact contact{1.93, 0.05};
    const auto foot = moving_point({319.5, 239.5}, contact, mapper(), {});
    const auto head = moving_point({319.5, 60.0}, contact, mapper(), {});
    ASSERT_TRUE(foot && head);
    EXPECT_NEAR(foot->position_m.x(), 1.93, 1e-9);
    EXPECT_NEAR(head->position_m.x(), 1.93, 1e-9);
    EXPECT_NEAR(foot->position_m.z(), 0.0, 0.01);
    EXPECT_GT(head->position_m.z(), 0.3);
    EXPECT_TRUE(foot->moving);
}

TEST(MovingPoint, LeftInTheImageIsLeftOfTheRobot) {
    const auto point = moving_point({100.0, 200.0}, {2.0, 0.05}, mapper(), {});
    ASSERT_TRUE(point);
    EXPECT_GT(point->position_m.y(), 0.3);
}

}  // namespace
}  // namespace flownav::obstacles
