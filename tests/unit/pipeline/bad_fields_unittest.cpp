#include <gtest/gtest.h>

#include "drives.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

using pipeline::Step;
using testing::cycles_of;
using testing::grey_field;

constexpr std::size_t bad = 3;

/// A drive in which one field is replaced by a grey one.
std::vector<Field> fields_with(std::uint8_t grey) {
    testing::DriveOptions options;
    options.images = 7;
    options.camera = testing::standard_camera(320, 240);
    std::vector<Field> fields = render_fields(testing::drive(options));
    fields[bad] = grey_field(fields[bad], grey, 0.0);
    return fields;
}

void expect_recovery(std::uint8_t grey) {
    const auto steps = testing::run(fields_with(grey), cycles_of(5));
    EXPECT_EQ(steps[bad].status, FieldStatus::BadField);
    EXPECT_FALSE(steps[bad].v_measured);
    EXPECT_FALSE(steps[bad].end_of_cycle);
    EXPECT_TRUE(steps[bad].obstacles.empty());
    EXPECT_FALSE(steps[bad].motion.omega_measured);
    for (const pipeline::BlockRecord& block : steps[bad].blocks) EXPECT_FALSE(block.fresh);
    // The reference is kept: the next field is compared with it.
    EXPECT_EQ(steps[bad + 1].status, FieldStatus::Ok);
    EXPECT_FALSE(steps[bad + 1].restarted);
    EXPECT_EQ(steps[bad + 1].image_of_cycle, 3);
    EXPECT_NEAR(steps.back().T_start_robot.x_m, 6 * 0.016, 0.004);
}

TEST(BadField, BlackIsSkippedAndTheChainGoesOn) {
    expect_recovery(0);
}

TEST(BadField, WhiteIsSkippedAndTheChainGoesOn) {
    expect_recovery(255);
}

TEST(BadField, ConstantGreyIsSkippedAndTheChainGoesOn) {
    expect_recovery(128);
}

TEST(BadField, RatesAfterItSpeakOfTheWholeTimeSinceTheLastPicture) {
    testing::DriveOptions options;
    options.images = 6;
    options.omega_degps = 15.0;
    options.camera = testing::standard_camera(320, 240);
    std::vector<Field> fields = render_fields(testing::drive(options));
    fields[bad] = grey_field(fields[bad], 0, 0.0);
    const auto steps = testing::run(fields, cycles_of(5));
    EXPECT_NEAR(deg(steps[bad + 1].omega_radps), 15.0, 1.0);
}

TEST(BadField, AtTheStartNothingIsKnownYet) {
    std::vector<Field> fields = fields_with(0);
    fields.insert(fields.begin(), grey_field(fields.front(), 0, -0.04));
    const auto steps = testing::run(fields, cycles_of(5));
    EXPECT_EQ(steps[0].status, FieldStatus::BadField);
    EXPECT_EQ(steps[1].status, FieldStatus::Waiting);
    EXPECT_FALSE(steps[1].restarted);
    EXPECT_EQ(steps[2].status, FieldStatus::Ok);
}

TEST(BadField, AnEmptyImageIsOne) {
    pipeline::State state({});
    Field field;
    field.camera = testing::standard_camera();
    EXPECT_EQ(pipeline::step(state, field).status, FieldStatus::BadField);
}

TEST(BadField, AStripeOfNoiseOnBlackIsOne) {
    // 5 % of the image has noise: a covered lens with a few disturbed lines.
    Field field = fields_with(0)[bad];
    auto image = std::make_shared<testing::GreyImage>(field.image.width_px, field.image.height_px);
    for (int v = 100; v < 112; ++v) {
        for (int u = 0; u < image->width_px; ++u)
            image->row(v)[u] = static_cast<std::uint8_t>((u * 37 + v * 11) % 256);
    }
    field.image = image->view();
    field.owner = image;
    pipeline::State state({});
    EXPECT_EQ(pipeline::step(state, field).status, FieldStatus::BadField);
}

TEST(LostField, PicturesThatHaveNothingInCommonAreNoMotion) {
    std::vector<Field> fields = fields_with(0);
    fields.resize(3);
    testing::DriveOptions elsewhere;
    elsewhere.kind = testing::SceneKind::Straight;
    elsewhere.images = 2;
    elsewhere.camera = testing::standard_camera(320, 240);
    testing::Scene other = testing::drive(elsewhere);
    other.poses[1] = {5.0, 1.0, 2.0};
    Field strange = make_field(other, 1);
    strange.timestamp_s = fields[2].timestamp_s;
    fields[2] = strange;
    const Step step = testing::run(fields, cycles_of(4)).back();
    EXPECT_NE(step.status, FieldStatus::Ok);
    EXPECT_FALSE(step.motion.omega_measured);
    EXPECT_FALSE(step.v_measured);
}

}  // namespace
}  // namespace flownav
