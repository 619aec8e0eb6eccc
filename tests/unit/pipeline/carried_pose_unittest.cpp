// Motion that is not measured is carried over for RateParams::carry_max_s, and no longer.
#include <gtest/gtest.h>

#include <algorithm>

#include "drives.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

using pipeline::Step;

constexpr int seen = 12;     // images; the last ones are measured
constexpr int hidden = 100;  // images, four seconds
constexpr double rate_hz = 25.0;

testing::DriveOptions left_turn() {
    testing::DriveOptions options;
    options.images = seen;
    options.omega_degps = 10.0;
    options.camera = testing::standard_camera(320, 240);
    return options;
}

std::vector<Field> seen_fields() {
    return render_fields(testing::drive(left_turn()));
}

/// Fields like the last one seen, with the pixels of `picture(i)`.
template <class Picture>
std::vector<Step> drive_into(Picture picture, const pipeline::Params& params = {}) {
    std::vector<Field> fields = seen_fields();
    const Field last = fields.back();
    for (int i = 1; i <= hidden; ++i) {
        Field field = picture(last, i);
        field.timestamp_s = last.timestamp_s + i / rate_hz;
        fields.push_back(field);
    }
    return testing::run(fields, params);
}

Field covered(const Field& like, int /*i*/) {
    return testing::grey_field(like, 2, 0.0);
}

/// A wall without texture: noise about one grey value, different in each image.
Field blank_wall(const Field& like, int i) {
    const auto image = std::make_shared<testing::GreyImage>(like.image.width_px, like.image.height_px);
    std::uint32_t state = 77U * static_cast<std::uint32_t>(i) + 1U;
    for (int v = 0; v < image->height_px; ++v) {
        for (int u = 0; u < image->width_px; ++u) {
            state = state * 1664525U + 1013904223U;
            image->row(v)[u] = static_cast<std::uint8_t>(120U + (state >> 29U));
        }
    }
    Field field = like;
    field.image = image->view();
    field.owner = image;
    return field;
}

double way_m(const Step& from, const Step& to) {
    return std::hypot(to.T_start_robot.x_m - from.T_start_robot.x_m,
                      to.T_start_robot.y_m - from.T_start_robot.y_m);
}

/// Expects a second at the last speed, then standstill; marked as carried, with a growing error.
void expect_carried_for_a_second(const std::vector<Step>& steps, FieldStatus status) {
    const Step& last = steps[seen - 1];
    ASSERT_EQ(last.status, FieldStatus::Ok);
    EXPECT_EQ(last.carried.since_s, 0.0);
    EXPECT_EQ(last.carried.sigma_m, 0.0);
    for (std::size_t i = seen + 3; i < steps.size(); ++i) ASSERT_EQ(steps[i].status, status) << i;
    EXPECT_NEAR(way_m(last, steps[seen + 10]), 11 * 0.016, 0.005);
    EXPECT_NEAR(way_m(last, steps.back()), 0.4 * 1.0, 0.02);
    const double turned_deg =
        deg(wrap_angle(steps.back().T_start_robot.yaw_rad - last.T_start_robot.yaw_rad));
    EXPECT_NEAR(turned_deg, 10.0 * 1.0, 1.0);
    EXPECT_LT(way_m(steps[seen + 30], steps.back()), 1e-9) << "still moving";
    EXPECT_EQ(steps.back().v_mps, 0.0);
    EXPECT_EQ(steps.back().omega_radps, 0.0);
    EXPECT_NEAR(steps.back().carried.since_s, hidden / rate_hz, 1e-6);
    for (std::size_t i = seen; i < steps.size(); ++i) {
        EXPECT_GT(steps[i].carried.sigma_m, steps[i - 1].carried.sigma_m) << i;
        EXPECT_GT(steps[i].carried.sigma_rad, steps[i - 1].carried.sigma_rad) << i;
    }
    // A robot that kept its speed would be 1.2 m farther.
    EXPECT_NEAR(steps.back().carried.sigma_m, 1.2, 0.25);
}

TEST(CarriedPose, ACoveredLensStopsTheOdometryAfterASecond) {
    expect_carried_for_a_second(drive_into(covered), FieldStatus::BadField);
}

TEST(CarriedPose, ABlankWallStopsTheOdometryAfterASecond) {
    expect_carried_for_a_second(drive_into(blank_wall), FieldStatus::NoTexture);
}

TEST(CarriedPose, TheTimeIsAParameter) {
    pipeline::Params params;
    params.rate.carry_max_s = 0.2;
    for (const auto& steps : {drive_into(covered, params), drive_into(blank_wall, params)})
        EXPECT_NEAR(way_m(steps[seen - 1], steps.back()), 0.4 * 0.2, 0.01);
    params.rate.carry_max_s = 0.0;
    EXPECT_LT(way_m(drive_into(covered, params)[seen - 1], drive_into(covered, params).back()), 1e-9);
}

/// The floor loses its texture; objects on it still show the turn.
TEST(CarriedPose, ASpeedThatTheFloorDoesNotShowGoesOnForASecondAsWell) {
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = seen + 50;
    std::vector<Field> fields = render_fields(testing::drive(options));
    options.floor = sim::Surface::Plain;
    const std::vector<Field> plain = render_fields(testing::drive(options));
    std::copy(plain.begin() + seen, plain.end(), fields.begin() + seen);
    const auto steps = testing::run(fields);
    const auto measured = [](const Step& s) { return s.motion.forward_measured; };
    ASSERT_TRUE(measured(steps[seen - 1]));
    ASSERT_TRUE(std::none_of(steps.begin() + seen + 4, steps.end(), measured)) << "the floor is not plain";
    EXPECT_NEAR(steps[seen + 10].v_mps, 0.4, 0.02);
    const auto relative = [](const Step& s) { return s.motion.sigma_forward_m / s.motion.forward_m; };
    EXPECT_GT(relative(steps[seen + 10]), 5 * relative(steps[seen - 1]));
    EXPECT_NEAR(way_m(steps[seen - 1], steps.back()), 0.4 * 1.0, 0.03);
    EXPECT_EQ(steps.back().v_mps, 0.0);
    EXPECT_GT(steps.back().carried.sigma_m, 0.3);
}

TEST(CarriedPose, TheErrorOfAStretchStaysWhenTheMotionIsMeasuredAgain) {
    std::vector<Field> fields = seen_fields();
    for (std::size_t i = 5; i < 8; ++i)
        fields[i] = testing::delayed(testing::grey_field(fields[i], 2, 0.0), 0.0);
    const auto steps = testing::run(fields);
    EXPECT_EQ(steps[4].carried.sigma_m, 0.0);
    EXPECT_GT(steps[7].carried.sigma_m, 0.0);
    ASSERT_EQ(steps.back().status, FieldStatus::Ok);
    EXPECT_EQ(steps.back().carried.since_s, 0.0);
    EXPECT_EQ(steps.back().carried.sigma_m, steps[7].carried.sigma_m);
}

}  // namespace
}  // namespace flownav
