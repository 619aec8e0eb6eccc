#include "flownav/report/contact_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "flownav/report/cause_style.h"
#include "flownav/testing/truth.h"
#include "step_samples.h"

namespace flownav::report {
namespace {

using Eigen::Vector3d;
using testing::pal_field;
using testing::step_at;

const FieldScale scale{1.0, 2.0};

cv::Mat plain_picture() {
    return scaled_field(pal_field(4), scale);
}

cv::Mat with_contacts(const ContactScan& scan) {
    cv::Mat picture = plain_picture();
    draw_contacts(picture, scan, pal_field(4).camera, scale);
    return picture;
}

cv::Mat with_floor(const ContactScan& scan) {
    cv::Mat picture = plain_picture();
    tint_free_floor(picture, scan, pal_field(4).camera, scale);
    return picture;
}

/// Pixel of a point of the floor in the robot frame, by the simulator's camera.
cv::Point pixel_of(double x_m, double y_m) {
    const auto pixel = testing::project({pal_field(4).camera, {}, 0.0}, Vector3d(x_m, y_m, 0.0));
    EXPECT_TRUE(pixel);
    return scale.at(*pixel);
}

/// True when a pixel within 2 pixels of `at` has the colour.
bool has_colour(const cv::Mat& picture, const cv::Point& at, const Colour& colour) {
    for (int y = at.y - 2; y <= at.y + 2; ++y)
        for (int x = at.x - 2; x <= at.x + 2; ++x)
            if (picture.at<cv::Vec3b>(y, x) == colour.bgr()) return true;
    return false;
}

/// Mean column of the pixels with the colour; NaN when there are none.
double mean_column(const cv::Mat& picture, const Colour& colour) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            if (picture.at<cv::Vec3b>(y, x) != colour.bgr()) continue;
            sum += x;
            ++count;
        }
    }
    return sum / count;
}

TEST(ContactDrawing, AContactIsDrawnWhereTheCameraSeesThatFloor) {
    const cv::Mat picture = with_contacts(step_at(4).contacts);
    // The camera is 0.1 m ahead of the axis and 0.05 m to its left.
    EXPECT_TRUE(has_colour(picture, pixel_of(0.1 + 1.5, 0.05 + 0.25 * 1.5), colour_of(BeamCause::Votes)));
    EXPECT_TRUE(has_colour(picture, pixel_of(0.1 + 2.0, 0.05 - 0.15 * 2.0), colour_of(BeamCause::Wall)));
}

TEST(ContactDrawing, APositiveTangentIsOnTheRightOfThePicture) {
    const cv::Mat picture = with_contacts(step_at(4).contacts);
    const double middle = picture.cols / 2.0;
    EXPECT_LT(mean_column(picture, colour_of(BeamCause::Votes)), middle);
    EXPECT_GT(mean_column(picture, colour_of(BeamCause::Wall)), middle);
    EXPECT_GT(mean_column(picture, colour_of(BeamCause::Drop)), middle);
}

TEST(ContactDrawing, ANearerContactIsLower) {
    ContactScan scan = step_at(4).contacts;
    scan.strips = {scan.strips[0], scan.strips[0]};
    scan.strips[1].cause = BeamCause::Wall;
    scan.strips[1].contact_m = scan.strips[1].near_m = 1.2;
    const cv::Mat picture = with_contacts(scan);
    const int wall_row = pixel_of(0.1 + 1.2, 0.05 + 0.15 * 1.2).y;
    EXPECT_TRUE(has_colour(picture, pixel_of(0.1 + 1.2, 0.05 + 0.15 * 1.2), colour_of(BeamCause::Wall)));
    EXPECT_GT(wall_row, pixel_of(0.1 + 1.5, 0.05 + 0.25 * 1.5).y);
}

TEST(ContactDrawing, FloorIsTintedUpToWhereItWasConfirmed) {
    ContactScan scan = step_at(4).contacts;
    scan.strips = {scan.strips[3]};
    scan.first = 0;
    scan.strips[0].free_m = 2.0;
    const cv::Mat plain = plain_picture();
    const cv::Mat picture = with_floor(scan);
    const auto changed = [&](double forward_m, double right) {
        const cv::Point at = pixel_of(0.1 + forward_m, 0.05 - right * forward_m);
        return picture.at<cv::Vec3b>(at) != plain.at<cv::Vec3b>(at);
    };
    EXPECT_TRUE(changed(1.5, 0.05));
    EXPECT_TRUE(changed(1.95, 0.05));
    EXPECT_FALSE(changed(2.1, 0.05)) << "beyond it";
    EXPECT_FALSE(changed(1.5, -0.05)) << "left of the strip";
    EXPECT_FALSE(changed(1.5, 0.15)) << "right of the strip";
}

TEST(ContactDrawing, AScanOfAnEarlierPoseIsDrawnWhereItsPlacesAreNow) {
    ContactScan scan = step_at(4).contacts;
    scan.T_robot_scan = {-0.3, 0.0, 0.0};  // the robot has driven on by 0.3 m
    const cv::Mat picture = with_contacts(scan);
    EXPECT_TRUE(has_colour(picture, pixel_of(0.1 + 1.2, 0.05 + 0.25 * 1.5), colour_of(BeamCause::Votes)));
}

TEST(ContactDrawing, AClosedGateShowsNothing) {
    ContactScan scan = step_at(4).contacts;
    scan.gate = ContactGate::PoorFloor;
    EXPECT_EQ(cv::norm(with_contacts(scan), plain_picture()), 0.0);
    EXPECT_EQ(cv::norm(with_floor(scan), plain_picture()), 0.0);
}

TEST(ContactDrawing, NumbersOutsideTheViewDoNoHarm) {
    for (const double wild : {0.0, -1.0, 1e-9, 1e9, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
        ContactScan scan = step_at(4).contacts;
        for (ContactStrip& strip : scan.strips) strip.free_m = strip.contact_m = strip.near_m = wild;
        scan.first = wild > 0.0 ? 100000 : -3;
        EXPECT_FALSE(with_contacts(scan).empty());
        EXPECT_FALSE(with_floor(scan).empty());
    }
}

}  // namespace
}  // namespace flownav::report
