#include "flownav/report/thumbnail_strip.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <random>

#include "step_samples.h"

namespace flownav::report {
namespace {

using testing::pal_field;
using testing::step_at;

/// A field that JPEG compresses badly.
Field noisy_field(int i) {
    constexpr int width = 720;
    constexpr int height = 270;
    std::mt19937 random(static_cast<unsigned>(i));
    auto pixels = std::make_shared<std::vector<std::uint8_t>>(width * height);
    for (auto& pixel : *pixels) pixel = static_cast<std::uint8_t>(random());
    Field field = pal_field(i);
    field.image = {pixels->data(), width, height, width};
    field.owner = pixels;
    return field;
}

std::size_t bytes_of(const ThumbnailStrip& strip) {
    std::size_t bytes = 0;
    for (const auto& picture : strip.pictures()) bytes += picture.jpeg.size();
    return bytes;
}

TEST(ThumbnailStrip, KeepsTheEndOfACycleAboutEveryHalfSecond) {
    ThumbnailStrip strip;
    for (int i = 0; i < 100; ++i) strip.offer(pal_field(i), step_at(i));
    const auto& pictures = strip.pictures();
    ASSERT_GE(pictures.size(), 6U);
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        EXPECT_EQ(pictures[k].points_m.size(), 2U) << "the end of a cycle has obstacle points";
        if (k == 0) continue;
        EXPECT_NEAR(pictures[k].timestamp_s - pictures[k - 1].timestamp_s, 0.6, 0.121);
    }
    EXPECT_EQ(pictures.front().labels.at(static_cast<std::size_t>(BlockLabel::Ground)), 1);
}

TEST(ThumbnailStrip, PointsAreInTheFrameOfTheStart) {
    ThumbnailStrip strip;
    for (int i = 0; i < 5; ++i) strip.offer(pal_field(i), step_at(i));
    const auto& picture = strip.pictures().back();
    const pipeline::Step step = step_at(4);
    const Eigen::Vector2d expected =
        transform(step.T_start_robot, Eigen::Vector2d(step.obstacles.front().position_m.head<2>()));
    EXPECT_LT((picture.points_m.front() - expected).norm(), 1e-12);
}

TEST(ThumbnailStrip, ContactsAreInTheFrameOfTheStart) {
    ThumbnailStrip strip;
    for (int i = 0; i < 5; ++i) strip.offer(pal_field(i), step_at(i));
    const auto& picture = strip.pictures().back();
    const pipeline::Step step = step_at(4);
    ASSERT_EQ(picture.contacts.size(), 3U);
    EXPECT_EQ(picture.strips.free, 2);
    const Eigen::Vector2d in_robot_m(0.1 + 1.4, 0.05 + 0.25 * 1.4);
    EXPECT_LT((picture.contacts[0].near_m - transform(step.T_start_robot, in_robot_m)).norm(), 1e-12);
}

TEST(ThumbnailStrip, APictureBetweenTwoScansShowsTheLastOne) {
    ThumbnailStrip strip;
    for (int i = 0; i < 7; ++i) {
        pipeline::Step step = step_at(i);
        if (i > 4) step.timestamp_s += 10.0;  // overdue: drawn in the middle of a cycle
        strip.offer(pal_field(i), step);
    }
    const auto& pictures = strip.pictures();
    ASSERT_EQ(pictures.size(), 2U);
    ASSERT_EQ(pictures[1].contacts.size(), 3U);
    EXPECT_LT((pictures[1].contacts[0].near_m - pictures[0].contacts[0].near_m).norm(), 1e-12)
        << "the same place of the world";
}

TEST(ThumbnailStrip, ADriveWithoutCyclesIsShownAllTheSame) {
    ThumbnailStrip strip;
    strip.offer(pal_field(0), step_at(0));
    EXPECT_EQ(strip.pictures().size(), 1U);
    for (int i = 1; i < 100; ++i) {
        pipeline::Step step = step_at(i);
        step.status = FieldStatus::Lost;
        step.end_of_cycle = false;
        strip.offer(pal_field(i), step);
    }
    EXPECT_GE(strip.pictures().size(), 3U);
    EXPECT_LE(strip.pictures().size(), 8U);
}

TEST(ThumbnailStrip, LongDrivesAndCoarsePicturesStayWithinTheBytes) {
    ThumbnailStrip strip;
    for (int i = 0; i < 1500; ++i) {
        pipeline::Step step = step_at(4 * (i / 4 + 1));
        step.timestamp_s = testing::start_s + i * testing::period_s;
        step.end_of_cycle = i % 4 == 0;
        strip.offer(noisy_field(i), step);
    }
    EXPECT_LE(bytes_of(strip), ThumbnailStrip::most_bytes);
    EXPECT_GT(bytes_of(strip), ThumbnailStrip::most_bytes / 4);
    const auto& pictures = strip.pictures();
    const double first_s = pictures[1].timestamp_s - pictures[0].timestamp_s;
    for (std::size_t k = 1; k < pictures.size(); ++k)
        EXPECT_NEAR(pictures[k].timestamp_s - pictures[k - 1].timestamp_s, first_s, 0.5 * first_s);
}

TEST(ThumbnailStrip, PicturesBecomeSmallerBeforeTheyBecomeRarer) {
    ThumbnailStrip strip;
    int width_px = 720;
    for (int i = 0; width_px == 720 && i < 2000; i += 15) {
        strip.offer(noisy_field(i), step_at(i));
        width_px = cv::imdecode(strip.pictures().front().jpeg, cv::IMREAD_COLOR).cols;
    }
    EXPECT_EQ(width_px, 640);
    const auto& pictures = strip.pictures();
    for (std::size_t k = 1; k < pictures.size(); ++k)
        EXPECT_LT(pictures[k].timestamp_s - pictures[k - 1].timestamp_s, 1.3);
    EXPECT_LE(bytes_of(strip), ThumbnailStrip::most_bytes);
}

TEST(ThumbnailStrip, DrawnInTheBackgroundItIsTheSame) {
    ThumbnailStrip at_once, in_background(true);
    for (int i = 0; i < 2000; ++i) {
        const Field field = i % 7 == 0 ? noisy_field(i) : pal_field(i);
        const pipeline::Step step = step_at(i);
        at_once.offer(field, step);
        in_background.offer(field, step);
    }
    in_background.finish();
    ASSERT_EQ(in_background.pictures().size(), at_once.pictures().size());
    for (std::size_t i = 0; i < at_once.pictures().size(); ++i) {
        EXPECT_EQ(in_background.pictures()[i].timestamp_s, at_once.pictures()[i].timestamp_s);
        EXPECT_EQ(in_background.pictures()[i].jpeg, at_once.pictures()[i].jpeg);
    }
}

TEST(ThumbnailStrip, PicturesShowShapesAtTheirTrueHeight) {
    ThumbnailStrip strip;
    strip.offer(pal_field(0), step_at(0));
    const cv::Mat picture = cv::imdecode(strip.pictures().front().jpeg, cv::IMREAD_COLOR);
    EXPECT_EQ(picture.cols, 720);
    EXPECT_EQ(picture.rows, 540) << "288 lines of half the density, 768 wide";
}

}  // namespace
}  // namespace flownav::report
