// What wheels and gyro tell when the flow does not measure the motion.
#include <gtest/gtest.h>

#include <algorithm>

#include "flownav/math/units.h"
#include "flownav/pipeline/sensor_report.h"
#include "told_drives.h"

namespace flownav {
namespace {

using pipeline::SensorUse;
using pipeline::Step;
using testing::RobotSensors;

/// A drive whose images are seen up to `seen` and have no texture after that.
struct HalfSeenDrive {
    std::vector<Field> fields;
    std::vector<Pose2> poses;
};

HalfSeenDrive drive_into_nothing(double v_mps, double omega_degps, std::size_t seen = 12, int images = 60) {
    testing::DriveOptions options;
    options.images = images;
    options.v_mps = v_mps;
    options.omega_degps = omega_degps;
    options.camera = testing::standard_camera(320, 240);
    const testing::Scene scene = testing::drive(options);
    HalfSeenDrive drive{{}, scene.poses};
    for (std::size_t i = 0; i < scene.poses.size(); ++i) {
        const bool see = i < seen;
        Field field = i <= seen ? make_field(scene, static_cast<int>(i)) : drive.fields[seen];
        field.timestamp_s = drive.fields.empty()
                                ? field.timestamp_s
                                : drive.fields[0].timestamp_s + static_cast<double>(i) / options.rate_hz;
        drive.fields.push_back(see ? field : testing::without_texture(field, static_cast<unsigned>(i)));
    }
    return drive;
}

Pose2 way_of(const std::vector<Pose2>& poses, std::size_t from, std::size_t to) {
    return compose(inverse(poses[from]), poses[to]);
}

Pose2 way_of(const std::vector<Step>& steps, std::size_t from, std::size_t to) {
    return compose(inverse(steps[from].T_start_robot), steps[to].T_start_robot);
}

/// Expects that the odometry follows the true motion from image 11 to the end, although nothing is seen.
void expect_told_motion(double v_mps, double omega_degps) {
    const HalfSeenDrive drive = drive_into_nothing(v_mps, omega_degps);
    const auto steps = testing::run(drive.fields, drive.poses, {true});
    const Pose2 truth = way_of(drive.poses, 11, 59);
    const Pose2 told = way_of(steps, 11, 59);
    EXPECT_NEAR(told.x_m, truth.x_m, 0.01);
    EXPECT_NEAR(told.y_m, truth.y_m, 0.01);
    EXPECT_NEAR(told.yaw_rad, truth.yaw_rad, 0.01);
    const Step& last = steps.back();
    EXPECT_EQ(last.motion.omega_source, MotionSource::Wheels);
    EXPECT_EQ(last.motion.forward_source, MotionSource::Wheels);
    EXPECT_TRUE(last.motion.omega_measured && last.motion.forward_measured);
    EXPECT_NEAR(last.v_mps, v_mps, 0.02);
    EXPECT_NEAR(deg(last.omega_radps), omega_degps, 1.0);
    EXPECT_EQ(last.carried.since_s, 0.0);
}

TEST(Wheels, TellTheWayForwardWhereNothingIsSeen) {
    expect_told_motion(0.4, 0.0);
}

TEST(Wheels, TellTheWayBackwardWhereNothingIsSeen) {
    expect_told_motion(-0.3, 0.0);
}

TEST(Wheels, TellATurnToTheLeftWhereNothingIsSeen) {
    expect_told_motion(0.3, 15.0);
}

TEST(Wheels, TellATurnToTheRightWhereNothingIsSeen) {
    expect_told_motion(0.3, -15.0);
}

TEST(Wheels, TheStatusStaysThatOfTheCamera) {
    const HalfSeenDrive drive = drive_into_nothing(0.4, 0.0);
    const auto steps = testing::run(drive.fields, drive.poses, {true});
    for (std::size_t i = 16; i < steps.size(); ++i) EXPECT_NE(steps[i].status, FieldStatus::Ok) << i;
}

TEST(Wheels, TheGuardsReportHasNoSpeedThatOnlyTheWheelsTold) {
    const HalfSeenDrive drive = drive_into_nothing(0.4, 0.0);
    const auto steps = testing::run(drive.fields, drive.poses, {true});
    bool cycle_ended = false;
    for (std::size_t i = 16; i < steps.size(); ++i) {
        cycle_ended = cycle_ended || steps[i].v_measured;
        EXPECT_FALSE(pipeline::sensor_report(steps[i], drive.fields[i].camera).v_measured) << i;
    }
    EXPECT_TRUE(cycle_ended) << "no cycle to report";
}

TEST(Wheels, GoOnWhenTheLensIsCovered) {
    HalfSeenDrive drive = drive_into_nothing(0.4, 10.0, 60);
    for (std::size_t i = 12; i < 50; ++i) drive.fields[i] = testing::grey_field(drive.fields[i], 2, 0.0);
    const auto steps = testing::run(drive.fields, drive.poses, {true});
    ASSERT_EQ(steps[30].status, FieldStatus::BadField);
    const Pose2 truth = way_of(drive.poses, 11, 49);
    const Pose2 told = way_of(steps, 11, 49);
    EXPECT_NEAR(told.x_m, truth.x_m, 0.01);
    EXPECT_NEAR(told.y_m, truth.y_m, 0.01);
    EXPECT_NEAR(told.yaw_rad, truth.yaw_rad, 0.01);
    EXPECT_EQ(steps[49].carried.since_s, 0.0);
}

TEST(Wheels, TellTheWayOverAGapBetweenTheImages) {
    HalfSeenDrive drive = drive_into_nothing(0.4, 10.0, 60);
    pipeline::State state(pipeline::Params{});
    std::vector<Step> steps;
    for (std::size_t i = 0; i < drive.fields.size(); ++i) {
        pipeline::note_wheels(state, {drive.fields[i].timestamp_s, drive.poses[i]});
        if (i >= 12 && i < 40) continue;
        steps.push_back(pipeline::step(state, drive.fields[i]));
    }
    ASSERT_EQ(steps[12].status, FieldStatus::Waiting);
    const Pose2 truth = way_of(drive.poses, 11, 40);
    const Pose2 told = way_of(steps, 11, 12);
    EXPECT_NEAR(told.x_m, truth.x_m, 0.005);
    EXPECT_NEAR(told.y_m, truth.y_m, 0.005);
    EXPECT_NEAR(told.yaw_rad, truth.yaw_rad, 0.005);
    EXPECT_EQ(steps[12].carried.since_s, 0.0);
}

TEST(Gyro, TellsTheTurnWhereNothingIsSeenAndLeavesTheWayCarriedOver) {
    for (const double omega_degps : {20.0, -20.0}) {
        const HalfSeenDrive drive = drive_into_nothing(0.3, omega_degps);
        const auto steps = testing::run(drive.fields, drive.poses, {false, true});
        EXPECT_NEAR(way_of(steps, 11, 59).yaw_rad, way_of(drive.poses, 11, 59).yaw_rad, 0.01);
        EXPECT_EQ(steps.back().motion.omega_source, MotionSource::Gyro);
        EXPECT_EQ(steps.back().motion.forward_source, MotionSource::Prediction);
        EXPECT_NEAR(steps.back().carried.since_s, 47 / 25.0, 0.09);
    }
}

TEST(Gyro, ItsBiasIsLearntWhileTheFlowMeasuresTheTurn) {
    const HalfSeenDrive drive = drive_into_nothing(0.3, 10.0, 60);
    RobotSensors sensors{false, true};
    sensors.gyro_bias_radps = -0.03;
    const auto steps = testing::run(drive.fields, drive.poses, sensors);
    EXPECT_NEAR(steps.back().other_sensors.gyro_bias_radps, -0.03, 0.006);
}

TEST(Gyro, ItsBiasIsLearntWhileTheWheelsStand) {
    HalfSeenDrive drive = drive_into_nothing(0.0, 0.0, 0, 100);
    RobotSensors sensors{true, true};
    sensors.gyro_bias_radps = 0.04;
    const auto steps = testing::run(drive.fields, drive.poses, sensors);
    EXPECT_NEAR(steps.back().other_sensors.gyro_bias_radps, 0.04, 0.003);
}

TEST(OtherSensors, AsAFallbackTheyChangeNothingThatTheFlowMeasures) {
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 20;
    options.omega_degps = 5.0;
    const testing::Scene scene = testing::drive(options);
    const auto fields = render_fields(scene);
    RobotSensors wrong{true, true};
    wrong.way_scale = 1.03;
    wrong.turn_scale = 0.97;
    const auto alone = testing::run(fields);
    const auto together = testing::run(fields, scene.poses, wrong);
    for (std::size_t i = 0; i < fields.size(); ++i)
        EXPECT_EQ(testing::fingerprint(alone[i]), testing::fingerprint(together[i])) << i;
    EXPECT_EQ(together.back().other_sensors.wheels_way.agreement, SensorAgreement::Agrees);
    EXPECT_EQ(together.back().motion.forward_source, MotionSource::Flow);
}

TEST(OtherSensors, SwitchedOffTheyChangeNothing) {
    const HalfSeenDrive drive = drive_into_nothing(0.4, 10.0);
    pipeline::Params off;
    off.other_sensors = {SensorUse::Off, SensorUse::Off};
    const auto alone = testing::run(drive.fields);
    const auto together = testing::run(drive.fields, drive.poses, {true, true}, off);
    for (std::size_t i = 0; i < alone.size(); ++i)
        EXPECT_EQ(testing::fingerprint(alone[i]), testing::fingerprint(together[i])) << i;
    EXPECT_EQ(together.back().other_sensors.wheels_way.agreement, SensorAgreement::NoReadings);
    EXPECT_EQ(together.back().other_sensors.gyro.agreement, SensorAgreement::NoReadings);
}

TEST(OtherSensors, WheelsThatContradictTheFlowAreReportedAndNotUsed) {
    const HalfSeenDrive drive = drive_into_nothing(0.4, 0.0, 40, 80);
    RobotSensors backward{true};
    backward.way_scale = -1.0;
    const auto steps = testing::run(drive.fields, drive.poses, backward);
    EXPECT_EQ(steps[39].other_sensors.wheels_way.agreement, SensorAgreement::Contradicts);
    EXPECT_NEAR(steps[39].other_sensors.wheels_way.ratio, -1.0, 0.05);
    EXPECT_EQ(steps.back().motion.forward_source, MotionSource::Prediction);
    EXPECT_NEAR(way_of(steps, 39, 79).x_m, 0.4 * 1.0, 0.03) << "not carried over for a second";
}

TEST(OtherSensors, AGyroOfTheWrongSignIsReportedAndTheWheelsTellTheTurn) {
    const HalfSeenDrive drive = drive_into_nothing(0.3, 15.0, 40, 80);
    pipeline::State state(pipeline::Params{});
    std::vector<Step> steps;
    for (std::size_t i = 0; i < drive.fields.size(); ++i) {
        pipeline::note_wheels(state, {drive.fields[i].timestamp_s, drive.poses[i]});
        pipeline::note_gyro(state, {drive.fields[i].timestamp_s, -15.0 * degree_rad});
        steps.push_back(pipeline::step(state, drive.fields[i]));
    }
    EXPECT_EQ(steps[39].other_sensors.gyro.agreement, SensorAgreement::Contradicts);
    EXPECT_EQ(steps.back().motion.omega_source, MotionSource::Wheels);
    EXPECT_NEAR(way_of(steps, 39, 79).yaw_rad, way_of(drive.poses, 39, 79).yaw_rad, 0.02);
}

TEST(OtherSensors, ReadingsOfAnotherClockAreReportedAndNotUsed) {
    const HalfSeenDrive drive = drive_into_nothing(0.4, 0.0);
    for (const double clock_s : {100.0, -100.0}) {
        RobotSensors sensors{true, true};
        sensors.clock_s = clock_s;
        const auto steps = testing::run(drive.fields, drive.poses, sensors);
        EXPECT_EQ(steps.back().other_sensors.wheels_way.agreement, SensorAgreement::NotInTime);
        EXPECT_EQ(steps.back().other_sensors.gyro.agreement, SensorAgreement::NotInTime);
        EXPECT_EQ(steps.back().motion.forward_source, MotionSource::Prediction);
    }
}

/// Share of the images whose obstacle blocks were found on a floor without texture between textured things.
int cycles_with_obstacles(const std::vector<Step>& steps) {
    return static_cast<int>(
        std::count_if(steps.begin(), steps.end(), [](const Step& s) { return s.counts.obstacle >= 5; }));
}

TEST(Wheels, OnAFloorWithoutTextureTheThingsOnItAreFound) {
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 40;
    options.floor = testing::Surface::Plain;
    const testing::Scene scene = testing::drive(options);
    const auto fields = render_fields(scene);
    const auto alone = testing::run(fields);
    const auto with_wheels = testing::run(fields, scene.poses, {true});
    EXPECT_EQ(cycles_with_obstacles(alone), 0);
    EXPECT_GT(cycles_with_obstacles(with_wheels), 20);
    EXPECT_EQ(with_wheels.back().motion.forward_source, MotionSource::Wheels);
    EXPECT_NEAR(with_wheels.back().v_mps, 0.4, 0.01);
}

/// A turn so fast that the search does not reach it: 300 px from image to image.
TEST(Gyro, FindsTheFlowOfATurnThatIsTooFastToSearch) {
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 8;
    testing::Scene scene = testing::drive(options);
    const double turn_rad = 300.0 / options.camera.fx_px;
    scene.poses[7] = compose(scene.poses[6], along_arc(turn_rad, 0.016));
    const auto fields = render_fields(scene);
    const auto alone = testing::run(fields);
    ASSERT_NE(alone.back().status, FieldStatus::Ok) << "the search finds it";
    for (const SensorUse use : {SensorUse::Fallback, SensorUse::Prior}) {
        pipeline::Params params;
        params.other_sensors.gyro = use;
        const auto steps = testing::run(fields, scene.poses, {false, true}, params);
        EXPECT_NEAR(steps.back().omega_radps * 0.04, turn_rad, 0.02);
    }
}

TEST(Prior, AveragesFlowAndWheelsByTheirErrors) {
    testing::DriveOptions options;
    options.images = 20;
    const testing::Scene scene = testing::drive(options);
    const auto fields = render_fields(scene);
    pipeline::Params params;
    params.other_sensors.wheels = SensorUse::Prior;
    RobotSensors long_wheels{true};
    long_wheels.way_scale = 1.02;
    const auto alone = testing::run(fields);
    const auto together = testing::run(fields, scene.poses, long_wheels, params);
    EXPECT_GT(together.back().motion.forward_m, alone.back().motion.forward_m);
    EXPECT_LT(together.back().motion.forward_m, 1.02 * alone.back().motion.forward_m);
    EXPECT_LT(together.back().motion.sigma_forward_m, alone.back().motion.sigma_forward_m);
}

}  // namespace
}  // namespace flownav
