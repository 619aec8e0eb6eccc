#include "flownav/testing/camera.h"

#include <gtest/gtest.h>

namespace flownav::testing {
namespace {

TEST(FieldCamera, RowOfTheTopFieldIsTwiceThatRowOfTheFrame) {
    const CameraModel frame = standard_camera(768, 576);
    const RayMapper in_frame(frame);
    const RayMapper in_field(field_camera(frame, Parity::Top));
    for (const int v : {0, 10, 287})
        EXPECT_LT((in_field.ray({100, v}) - in_frame.ray({100, 2 * v})).norm(), 1e-12);
}

TEST(FieldCamera, RowOfTheBottomFieldIsTheRowAfterIt) {
    const CameraModel frame = standard_camera(768, 576);
    const RayMapper in_frame(frame);
    const RayMapper in_field(field_camera(frame, Parity::Bottom));
    for (const int v : {0, 10, 287})
        EXPECT_LT((in_field.ray({100, v}) - in_frame.ray({100, 2 * v + 1})).norm(), 1e-12);
}

TEST(FieldCamera, FieldsOfAnEvenFrameShareTheirRowsAndDifferByHalfALine) {
    const CameraModel frame = standard_camera(768, 576);
    const CameraModel top = field_camera(frame, Parity::Top);
    const CameraModel bottom = field_camera(frame, Parity::Bottom);
    EXPECT_EQ(top.height_px, 288);
    EXPECT_EQ(bottom.height_px, 288);
    EXPECT_DOUBLE_EQ(top.cy_px - bottom.cy_px, 0.5);
    EXPECT_TRUE(same_geometry(top, bottom));
}

TEST(FieldCamera, TopFieldOfAnOddFrameHasTheExtraRow) {
    const CameraModel frame = standard_camera(64, 49);
    EXPECT_EQ(field_camera(frame, Parity::Top).height_px, 25);
    EXPECT_EQ(field_camera(frame, Parity::Bottom).height_px, 24);
}

}  // namespace
}  // namespace flownav::testing
