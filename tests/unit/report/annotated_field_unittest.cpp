#include "flownav/report/annotated_field.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "step_samples.h"

namespace flownav::report {
namespace {

using testing::pal_field;
using testing::step_at;

TEST(AnnotatedField, ShowsAFieldOfHalfTheLinesAtItsTrueHeight) {
    const cv::Mat picture = annotated_field(pal_field(4), step_at(4), {});
    EXPECT_EQ(picture.cols, 768);
    EXPECT_GT(picture.rows, 2 * 288) << "and a legend below";
    EXPECT_LT(picture.rows, 2 * 288 + 120);
}

TEST(AnnotatedField, PutsTheArrowOfAnObstacleWhereItsBlockIsNow) {
    const cv::Mat picture = annotated_field(pal_field(4), step_at(4), {});
    // The block at (100, 50) moved by (4, 12) pixels: its tip is near (104, 2 * 62).
    const cv::Mat around = picture(cv::Rect(104 - 8, 124 - 8, 16, 16));
    int vermilion = 0;
    for (int y = 0; y < around.rows; ++y) {
        for (int x = 0; x < around.cols; ++x)
            vermilion += around.at<cv::Vec3b>(y, x) == cv::Vec3b(0, 94, 213);
    }
    EXPECT_GT(vermilion, 5);
}

TEST(AnnotatedField, ShowsTheContactsOfTheScanItIsGiven) {
    const cv::Mat without = annotated_field(pal_field(4), step_at(4), {});
    const cv::Mat with = annotated_field(pal_field(4), step_at(4), step_at(4).contacts);
    ASSERT_EQ(with.size(), without.size()) << "the legend keeps its height";
    EXPECT_GT(cv::norm(with.rowRange(0, 576), without.rowRange(0, 576)), 1000.0);
}

TEST(AnnotatedField, SmallAndLargeImagesMakePicturesOfReadableSize) {
    for (const int width : {64, 160, 1241, 4096}) {
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * 48, 100);
        Field field;
        field.image = {pixels.data(), width, 48, width};
        field.camera.fx_px = field.camera.fy_px = 100;
        const cv::Mat picture = annotated_field(field, step_at(4), step_at(4).contacts);
        EXPECT_GE(picture.cols, 700) << width;
        EXPECT_LE(picture.cols, 1300) << width;
    }
}

TEST(AnnotatedField, VectorsBesideThePictureDoNoHarm) {
    pipeline::Step step = step_at(4);
    step.blocks[0].vector.at_px = {-500, 9000};
    step.blocks[1].vector.flow_px = {1e6, -1e6};
    EXPECT_FALSE(annotated_field(pal_field(4), step, {}).empty());
}

}  // namespace
}  // namespace flownav::report
