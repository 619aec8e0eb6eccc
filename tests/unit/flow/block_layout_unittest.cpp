#include "flownav/flow/block_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "flownav/core/plane_geometry.h"
#include "flownav/flow/kernel.h"
#include "flownav/testing/camera.h"

namespace flownav::flow {
namespace {

const CameraModel camera = testing::standard_camera();

BlockLayout layout_of(const FlowParams& params, const CameraModel& c = camera) {
    return place_blocks(RayMapper(c), params);
}

TEST(BlockLayout, PlacesAsManyBlocksAsAsked) {
    for (const int n : {16, 35, 350, 2000}) {
        FlowParams params;
        params.blocks = n;
        EXPECT_EQ(layout_of(params).size(), static_cast<std::size_t>(n));
    }
}

TEST(BlockLayout, KeepsEveryBlockInsideTheImage) {
    const BlockLayout layout = layout_of({});
    ASSERT_GT(layout.size(), 0U);
    for (const auto& corner : layout.corner_px) {
        EXPECT_GE(corner.x(), 0);
        EXPECT_GE(corner.y(), 0);
        EXPECT_LE(corner.x() + block_px, camera.width_px);
        EXPECT_LE(corner.y() + block_px, camera.height_px);
    }
}

TEST(BlockLayout, CentreLiesHalfAPixelBeforeTheMiddleOfSixteen) {
    const BlockLayout layout = layout_of({});
    EXPECT_DOUBLE_EQ(layout.centre_px[0].x(), layout.corner_px[0].x() + 7.5);
    EXPECT_DOUBLE_EQ(layout.centre_px[0].y(), layout.corner_px[0].y() + 7.5);
}

TEST(BlockLayout, LeavesTheBlindConeEmpty) {
    const RayMapper mapper(camera);
    const PlaneGeometry plane(camera.mount);
    const BlockLayout layout = layout_of({});
    ASSERT_GT(layout.size(), 0U);
    for (const auto& centre : layout.centre_px) EXPECT_GE(plane.e(mapper.ray(centre)).norm(), 0.25);
}

TEST(BlockLayout, IsDenserTowardTheHorizon) {
    const BlockLayout layout = layout_of({});
    const auto share = [&](double low, double high) {
        return std::count_if(layout.centre_px.begin(), layout.centre_px.end(), [&](const auto& c) {
            return c.y() >= low * camera.height_px && c.y() < high * camera.height_px;
        });
    };
    EXPECT_GT(share(0.2, 0.4), 2 * share(0.8, 1.0));
}

TEST(BlockLayout, GroundWindowHasAtLeastTwelveBlocksHoweverFewThereAre) {
    FlowParams params;
    params.blocks = 40;
    const BlockLayout layout = layout_of(params);
    EXPECT_GE(std::count(layout.in_ground_window.begin(), layout.in_ground_window.end(), 1),
              ground_window_min);
    EXPECT_EQ(layout.size(), 40U);
}

TEST(BlockLayout, NeighboursAreNearAndNeverTheBlockItself) {
    const BlockLayout layout = layout_of({});
    for (std::size_t i = 0; i < layout.size(); ++i) {
        double farthest = 0.0;
        for (const int k : layout.neighbours[i]) {
            ASSERT_GE(k, 0);
            EXPECT_NE(k, static_cast<int>(i));
            farthest = std::max(farthest, (layout.centre_px[k] - layout.centre_px[i]).norm());
        }
        EXPECT_LT(farthest, 200.0);
    }
}

TEST(BlockLayout, AnImageSmallerThanABlockGetsNone) {
    CameraModel tiny = camera;
    tiny.width_px = tiny.height_px = 12;
    EXPECT_EQ(layout_of({}, tiny).size(), 0U);
}

TEST(BlockLayout, IsTheSameEveryTime) {
    EXPECT_EQ(layout_of({}).corner_px, layout_of({}).corner_px);
}

}  // namespace
}  // namespace flownav::flow
