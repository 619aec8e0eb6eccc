#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "flownav/math/units.h"
#include "flownav/testing/camera.h"
#include "rendered.h"

/// Disables leak detection under sanitizers, because Mesa's drivers keep one-time allocations; other tests
/// detect leaks of the project.
extern "C" const char* __asan_default_options() {  // NOLINT
    return "detect_leaks=0";
}

namespace flownav::sim {
namespace {

/// A wall of boxes 3 m ahead.
World wall_world() {
    World world;
    Solid wall;
    wall.shape = Box{{0.2, 12.0, 4.0}};
    wall.T_world_solid.translation() << 3.1, 0.0, 2.0;
    wall.look = {Surface::Patterned, 130.0, 5};
    world.solids = {wall};
    return world;
}

CameraModel small_camera() {
    return testing::standard_camera(320, 240);
}

cv::Mat1b shot(const CameraModel& camera, const Pose2& pose) {
    CameraSimulator simulator(wall_world(), clean(camera));
    return picture_of(simulator.take(0, pose, 0.0));
}

cv::Point2d shift_by(const Pose2& pose) {
    return mean_shift(shot(small_camera(), {}), shot(small_camera(), pose));
}

cv::Point2d shift_by(double CameraMount::*angle) {
    CameraModel camera = small_camera();
    camera.mount.*angle += 0.5 * degree_rad;
    return mean_shift(shot(small_camera(), {}), shot(camera, {}));
}

TEST(CameraSigns, ARobotFurtherLeftSeesThingsFurtherRight) {
    const cv::Point2d shift = shift_by(Pose2{0.0, 0.02, 0.0});
    EXPECT_GT(shift.x, 1.0);
    EXPECT_NEAR(shift.y, 0.0, 0.2);
}

TEST(CameraSigns, ATurnToTheLeftMovesThingsToTheRight) {
    const cv::Point2d shift = shift_by(Pose2{0.0, 0.0, 0.5 * degree_rad});
    EXPECT_NEAR(shift.x, small_camera().fx_px * 0.5 * degree_rad, 0.6);
}

TEST(CameraSigns, ComingNearerMovesTheFloorDownAndMakesTheWallGrow) {
    EXPECT_GT(shift_by(Pose2{0.05, 0.0, 0.0}).y, 0.5);
    const cv::Mat1b from = shot(small_camera(), {});
    const cv::Mat1b to = shot(small_camera(), Pose2{0.05, 0.0, 0.0});
    const cv::Rect left(0, 0, 160, 240);
    const cv::Rect right(160, 0, 160, 240);
    EXPECT_LT(mean_shift(from(left).clone(), to(left).clone()).x, -0.5);
    EXPECT_GT(mean_shift(from(right).clone(), to(right).clone()).x, 0.5);
}

TEST(CameraSigns, LookingFurtherDownMovesThingsUp) {
    EXPECT_NEAR(shift_by(&CameraMount::pitch_rad).y, -small_camera().fy_px * 0.5 * degree_rad, 0.5);
}

TEST(CameraSigns, ACameraTurnedToTheLeftSeesThingsFurtherRight) {
    EXPECT_GT(shift_by(&CameraMount::yaw_rad).x, 1.0);
}

TEST(CameraSigns, ACameraTiltedToItsRightSeesThingsTurnToTheLeft) {
    CameraModel camera = small_camera();
    camera.mount.roll_rad = 1.0 * degree_rad;
    const cv::Mat1b from = shot(small_camera(), {});
    const cv::Mat1b to = shot(camera, {});
    const cv::Rect left(0, 0, 120, 240);
    const cv::Rect right(200, 0, 120, 240);
    EXPECT_GT(mean_shift(from(left).clone(), to(left).clone()).y, 0.5);
    EXPECT_LT(mean_shift(from(right).clone(), to(right).clone()).y, -0.5);
}

TEST(CameraSigns, AThingThatMovesToTheRightDoesSoInThePicture) {
    World world = wall_world();
    world.floor.surface = Surface::Plain;
    Solid& wall = world.solids[0];
    Eigen::Isometry3d later = wall.T_world_solid;
    later.translation().y() -= 0.04;
    wall.script = {{0.0, wall.T_world_solid}, {1.0, later}};
    CameraSimulator simulator(world, clean(small_camera()));
    const cv::Mat1b before = picture_of(simulator.take(0, {}, 0.0));
    const cv::Mat1b after = picture_of(simulator.take(1, {}, 1.0));
    EXPECT_GT(mean_shift(before, after).x, 2.0);
}

TEST(CameraSeeds, TheSameSeedGivesTheSameBytesInAnyOrder) {
    CameraSimParams params = clean(small_camera());
    params.effects.noise_sigma = 2.0;
    params.effects.pitch_vibration_deg = 0.05;
    params.effects.roll_vibration_deg = 0.05;
    params.effects.exposure_step = 0.1;
    const Pose2 pose{0.1, 0.0, 0.02};
    CameraSimulator one(wall_world(), params);
    CameraSimulator other(wall_world(), params);
    const cv::Mat1b picture = picture_of(one.take(5, pose, 0.2));
    other.take(9, {}, 0.0);
    EXPECT_EQ(cv::norm(picture, picture_of(other.take(5, pose, 0.2)), cv::NORM_INF), 0.0);
    EXPECT_GT(cv::norm(picture, picture_of(other.take(6, pose, 0.2)), cv::NORM_INF), 0.0);
    params.effects.seed = 2;
    CameraSimulator third(wall_world(), params);
    EXPECT_GT(cv::norm(picture, picture_of(third.take(5, pose, 0.2)), cv::NORM_INF), 0.0);
}

TEST(CameraEffectsOnPictures, NoiseHasItsSigmaAndNoMean) {
    CameraSimParams params = clean(small_camera());
    CameraSimulator quiet(wall_world(), params);
    params.effects.noise_sigma = 3.0;
    CameraSimulator noisy(wall_world(), params);
    cv::Mat difference;
    cv::subtract(picture_of(noisy.take(0, {}, 0.0)), picture_of(quiet.take(0, {}, 0.0)), difference,
                 cv::noArray(), CV_32F);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(difference, mean, deviation);
    EXPECT_NEAR(mean[0], 0.0, 0.05);
    EXPECT_NEAR(deviation[0], 3.0, 0.1);
}

TEST(CameraEffectsOnPictures, VibrationMovesThePictureAndNotTheCalibration) {
    CameraSimParams params = clean(small_camera());
    CameraSimulator still(wall_world(), params);
    params.effects.pitch_vibration_deg = 0.3;
    CameraSimulator shaking(wall_world(), params);
    const cv::Mat1b expected = picture_of(still.take(0, {}, 0.0));
    double squares_px = 0.0;
    for (int image = 0; image < 20; ++image) {
        const Field field = shaking.take(image, {}, 0.0);
        EXPECT_EQ(field.camera.mount.pitch_rad, params.camera.mount.pitch_rad);
        const double shift_px = mean_shift(expected, picture_of(field)).y;
        squares_px += shift_px * shift_px / 20;
    }
    EXPECT_NEAR(std::sqrt(squares_px), small_camera().fy_px * 0.3 * degree_rad, 0.6);
}

TEST(CameraEffectsOnPictures, ExposureVignettingAndBlurDoWhatTheySay) {
    World plain;
    plain.floor = {Surface::Plain, 100.0, 1};
    CameraSimParams params = clean(small_camera());
    params.camera.mount.pitch_rad = 50 * degree_rad;
    params.effects.gain = 1.5;
    CameraSimulator gained(plain, params);
    EXPECT_NEAR(picture_of(gained.take(0, {}, 0.0))(120, 160), 150, 1);
    params.effects.gain = 1.0;
    params.effects.vignetting = 0.4;
    CameraSimulator vignetted(plain, params);
    const cv::Mat1b picture = picture_of(vignetted.take(0, {}, 0.0));
    EXPECT_NEAR(picture(120, 160), 100, 1);
    EXPECT_NEAR(picture(0, 0), 60, 2);
    EXPECT_NEAR(picture(239, 319), 60, 2);

    params = clean(small_camera());
    params.effects.blur_px = 1.5;
    CameraSimulator blurred(wall_world(), params);
    cv::Scalar mean;
    cv::Scalar sharp;
    cv::Scalar soft;
    cv::meanStdDev(shot(small_camera(), {}), mean, sharp);
    cv::meanStdDev(picture_of(blurred.take(0, {}, 0.0)), mean, soft);
    EXPECT_LT(soft[0], 0.95 * sharp[0]);
}

TEST(CameraParams, WithoutSenseAreRefused) {
    CameraSimParams params = clean(small_camera());
    params.supersampling = 0;
    EXPECT_THROW(CameraSimulator(World{}, params), std::invalid_argument);
    params = clean(small_camera());
    params.camera.fx_px = 0.0;
    EXPECT_THROW(CameraSimulator(World{}, params), std::invalid_argument);
    params = clean(small_camera());
    params.effects.noise_sigma = NAN;
    EXPECT_THROW(CameraSimulator(World{}, params), std::invalid_argument);
    params = clean(small_camera());
    CameraSimulator simulator(World{}, params);
    EXPECT_THROW(simulator.take(-1, {}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace flownav::sim
