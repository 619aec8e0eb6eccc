#include "flownav/obstacles/floor_registration.h"

#include <gtest/gtest.h>

#include "level_world.h"

namespace flownav::obstacles {
namespace {

using testing::draw;
using testing::LevelView;
using testing::LevelWorld;

constexpr double noise = 0.8;

/// Standard deviations of a drive of 16 cm.
PairPrior usual() {
    PairPrior prior;
    prior.forward_m = 0.004;
    prior.right_m = 0.0013;
    return prior;
}

PairMotion register_pair(const LevelView& reference, const LevelView& newer, const PairMotion& measured,
                         const PairPrior& prior = usual()) {
    const LevelWorld world;
    RegistrationScratch scratch;
    const LevelImage image = draw(world, newer);
    choose_floor_pixels(image, noise, scratch);
    return register_floor(draw(world, reference), image, measured, prior, noise, scratch);
}

/// A drive of 16 cm straight ahead, seen with `newer`; the other parameters are measured as 0.
PairMotion register_drive(LevelView newer, const PairPrior& prior) {
    newer.T_world_camera.x_m = 0.16;
    return register_pair({}, newer, {0.16}, prior);
}

TEST(FloorRegistration, FindsTheWayAhead) {
    LevelView newer;
    newer.T_world_camera.x_m = 0.16;
    EXPECT_NEAR(register_pair({}, newer, {0.156}).forward_m, 0.16, 0.001);
    EXPECT_NEAR(register_pair({}, newer, {0.164}).forward_m, 0.16, 0.001);
}

TEST(FloorRegistration, ASlideToTheRightIsPositive) {
    LevelView newer;
    newer.T_world_camera = {0.16, -0.003, 0.0};
    PairPrior prior = usual();
    prior.right_m = 0.05;
    const PairMotion motion = register_pair({}, newer, {0.16}, prior);
    EXPECT_NEAR(motion.right_m, 0.003, 0.0015);
}

TEST(FloorRegistration, ATurnToTheLeftIsPositive) {
    LevelView newer;
    newer.T_world_camera.yaw_rad = 0.004;
    PairPrior prior = usual();
    prior.omega_rad = 0.05;
    EXPECT_NEAR(register_drive(newer, prior).omega_rad, 0.004, 0.0006);
}

TEST(FloorRegistration, RaisingTheViewIsAPositivePitch) {
    LevelView newer;
    newer.pitch_rad -= 0.002;
    PairPrior prior = usual();
    prior.pitch_rad = 0.05;
    EXPECT_NEAR(register_drive(newer, prior).pitch_rad, 0.002, 0.0006);
}

TEST(FloorRegistration, APictureTurnedClockwiseIsAPositiveRoll) {
    LevelView newer;
    newer.roll_rad = 0.003;
    PairPrior prior = usual();
    prior.roll_rad = 0.05;
    EXPECT_NEAR(register_drive(newer, prior).roll_rad, 0.003, 0.0006);
}

TEST(FloorRegistration, WithoutTextureTheMeasuredMotionStays) {
    LevelWorld world;
    world.contrast = 0.0;
    LevelView newer;
    newer.T_world_camera.x_m = 0.16;
    RegistrationScratch scratch;
    const LevelImage image = draw(world, newer);
    choose_floor_pixels(image, noise, scratch);
    const PairMotion motion =
        register_floor(draw(world, {}), image, {0.15, 0.01, 0.02}, usual(), noise, scratch);
    EXPECT_EQ(motion.forward_m, 0.15);
    EXPECT_EQ(motion.right_m, 0.01);
    EXPECT_EQ(motion.omega_rad, 0.02);
}

TEST(FloorWarp, AFloorThatRisesAheadHasAPositiveSlope) {
    // Floor 0.02 m higher one metre ahead is where a level floor seems to be nearer.
    const LevelCamera camera = testing::level_camera();
    PairMotion motion;
    motion.slope = 0.02;
    const PairWarp warp = pair_warp(camera, camera, motion);
    const Eigen::Vector3d pixel(camera.cx_px, 150.0, 1.0);
    const double forward_m = warp.forward.dot(pixel) / warp.floor.dot(pixel);
    const double drop_m = forward_m * camera.below_horizon(150.0);
    EXPECT_NEAR(camera.height_m - drop_m, 0.02 * forward_m, 1e-9);
}

TEST(FloorWarp, AFloorThatRisesToTheRightHasAPositiveCrossSlope) {
    const LevelCamera camera = testing::level_camera();
    PairMotion motion;
    motion.cross_slope = 0.02;
    const PairWarp warp = pair_warp(camera, camera, motion);
    const double right = warp.floor.dot(Eigen::Vector3d(250.0, 180.0, 1.0));
    const double left = warp.floor.dot(Eigen::Vector3d(70.0, 180.0, 1.0));
    EXPECT_GT(right, left);  // inverse distance: higher floor is nearer
}

}  // namespace
}  // namespace flownav::obstacles
