// Refused fields change only the status and a count.
#include <gtest/gtest.h>

#include <limits>

#include "drives.h"

namespace flownav {
namespace {

using pipeline::Step;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t odd = 4;

std::vector<Field> good_fields() {
    testing::DriveOptions options;
    options.images = 9;
    options.camera = testing::standard_camera(320, 240);
    return render_fields(testing::drive(options));
}

std::uint64_t count_of(const Step& step, FieldFault fault) {
    return step.faults.at(static_cast<std::size_t>(fault));
}

/// Inserts a refused field; the drive must end as without it.
template <class Spoil>
void expect_refused(FieldFault fault, Spoil spoil) {
    const std::vector<Field> good = good_fields();
    std::vector<Field> fields = good;
    Field strange = good[odd];
    spoil(strange, good[odd - 1]);
    fields.insert(fields.begin() + odd, strange);
    const auto steps = testing::run(fields);
    EXPECT_EQ(steps[odd].status, FieldStatus::BadField);
    EXPECT_EQ(steps[odd].fault, fault);
    EXPECT_TRUE(std::isfinite(steps[odd].timestamp_s));
    EXPECT_EQ(steps[odd].omega_radps, steps[odd - 1].omega_radps);
    EXPECT_EQ(count_of(steps.back(), fault), 1U);
    EXPECT_EQ(count_of(steps.back(), FieldFault::None), good.size());
    const Step without = testing::run(good).back();
    EXPECT_EQ(steps.back().status, FieldStatus::Ok);
    EXPECT_EQ(steps.back().T_start_robot.x_m, without.T_start_robot.x_m);
    EXPECT_EQ(steps.back().T_start_robot.yaw_rad, without.T_start_robot.yaw_rad);
    EXPECT_EQ(steps.back().v_mps, without.v_mps);
}

TEST(RefusedField, ATimeStampThatComesTwice) {
    expect_refused(FieldFault::TimeNotRising,
                   [](Field& field, const Field& before) { field.timestamp_s = before.timestamp_s; });
}

TEST(RefusedField, ATimeStampThatGoesBack) {
    expect_refused(FieldFault::TimeNotRising,
                   [](Field& field, const Field& before) { field.timestamp_s = before.timestamp_s - 10.0; });
}

TEST(RefusedField, ATimeStampThatIsNoNumber) {
    for (const double time_s : {not_a_number, std::numeric_limits<double>::infinity()}) {
        expect_refused(FieldFault::TimeNotRising,
                       [&](Field& field, const Field&) { field.timestamp_s = time_s; });
    }
}

/// Sets a valid time stamp half-way to the next field.
void half_way(Field& field, const Field& before) {
    field.timestamp_s = (field.timestamp_s + before.timestamp_s) / 2;
}

TEST(RefusedField, AnImageThatIsSmallerOrLargerThanItsCameraSays) {
    for (const int change_px : {-1, -100, 1}) {
        expect_refused(FieldFault::WrongSize, [&](Field& field, const Field& before) {
            half_way(field, before);
            field.image.width_px += change_px;
        });
        expect_refused(FieldFault::WrongSize, [&](Field& field, const Field& before) {
            half_way(field, before);
            field.image.height_px += change_px;
        });
    }
}

TEST(RefusedField, AnImageWhoseRowsOverlap) {
    expect_refused(FieldFault::WrongSize, [](Field& field, const Field& before) {
        half_way(field, before);
        field.image.stride_bytes = field.image.width_px - 1;
    });
}

TEST(RefusedField, ACameraWhoseNumbersCannotBeUsed) {
    const auto refused = [](double CameraModel::*number, double value) {
        expect_refused(FieldFault::BadCamera, [&](Field& field, const Field& before) {
            half_way(field, before);
            field.camera.*number = value;
        });
    };
    refused(&CameraModel::fx_px, 0.0);
    refused(&CameraModel::fy_px, -300.0);
    refused(&CameraModel::cx_px, not_a_number);
}

TEST(RefusedField, TheVeryFirstFieldMayBeOne) {
    std::vector<Field> fields = good_fields();
    Field first = fields.front();
    first.timestamp_s = not_a_number;
    fields.insert(fields.begin(), first);
    const auto steps = testing::run(fields);
    EXPECT_EQ(steps[0].fault, FieldFault::TimeNotRising);
    EXPECT_EQ(steps[1].status, FieldStatus::Waiting);
    EXPECT_EQ(steps.back().status, FieldStatus::Ok);
    EXPECT_EQ(steps.back().carried.sigma_m, 0.0);
}

}  // namespace
}  // namespace flownav
