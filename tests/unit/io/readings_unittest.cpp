// Readings of wheels and gyro in a rawlog, and the fields that wait for them.
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationIMU.h>

#include <cmath>

#include "flownav/io/field_source.h"
#include "flownav/math/units.h"
#include "rawlog_files.h"

namespace flownav::io {
namespace {

using namespace flownav::testing;
using Objects = std::vector<mrpt::serialization::CSerializable::ConstPtr>;

mrpt::obs::CObservationIMU::Ptr gyro_at(double timestamp_s, double omega_radps,
                                        const std::string& label = "IMU") {
    auto imu = mrpt::obs::CObservationIMU::Create();
    imu->timestamp = mrpt::Clock::fromDouble(timestamp_s);
    imu->sensorLabel = label;
    imu->set(mrpt::obs::IMU_WZ, omega_radps);
    return imu;
}

struct Events {
    std::vector<SensorEvent> all;
    InputCounts counts;

    /// One letter an event: f field, w wheels, t ground truth, g gyro.
    std::string order() const {
        std::string letters;
        for (const SensorEvent& event : all) {
            if (const auto* pose = std::get_if<PoseSample>(&event)) {
                letters += pose->source == PoseSample::Source::Odometry ? 'w' : 't';
            } else {
                letters += std::holds_alternative<Field>(event) ? 'f' : 'g';
            }
        }
        return letters;
    }
    std::vector<GyroRate> gyro() const {
        std::vector<GyroRate> readings;
        for (const SensorEvent& event : all)
            if (const auto* reading = std::get_if<GyroRate>(&event)) readings.push_back(*reading);
        return readings;
    }
};

Events read(const Objects& objects) {
    const auto file = test_folder() / "input.rawlog";
    write_bytes(file, gz(serialized(objects)));
    RawlogReader reader(file);
    FieldSource source(reader, {});
    Events events;
    while (auto event = source.next()) events.all.push_back(std::move(*event));
    events.counts = source.counts();
    return events;
}

TEST(Readings, AFieldWaitsForTheFirstReadingOfTheWheelsThatIsNotBeforeIt) {
    const Events events = read({odometry_at(1.00, 0.0), image_at(1.02), odometry_at(1.05, 0.1),
                                image_at(1.06), odometry_at(1.10, 0.2), image_at(1.10)});
    EXPECT_EQ(events.order(), "wwfwff");
}

TEST(Readings, AFieldWaitsForWheelsAndGyro) {
    const Events events = read({odometry_at(1.0, 0.0), gyro_at(1.0, 0.1), image_at(1.02),
                                odometry_at(1.05, 0.1), gyro_at(1.01, 0.1), gyro_at(1.03, 0.1)});
    EXPECT_EQ(events.order(), "wgwggf");
}

TEST(Readings, WithoutReadingsEventsKeepTheOrderOfTheFile) {
    const Events events =
        read({image_at(1.0), truth_at(1.0, 0.0), image_at(1.04), truth_at(1.04, 0.0), image_at(1.08)});
    EXPECT_EQ(events.order(), "ftftf");
}

TEST(Readings, AFieldDoesNotWaitForReadingsThatHaveStopped) {
    Objects objects = {odometry_at(1.0, 0.0)};
    for (int i = 1; i <= 8; ++i) objects.push_back(image_at(1.0 + 0.1 * i));
    objects.push_back(truth_at(2.0, 0.0));
    // The first fields wait in vain, up to three at a time.
    EXPECT_EQ(read(objects).order(), "wfffffffft");
}

TEST(Readings, AFieldWaitsBehindThreeOthersAtTheMost) {
    Objects objects = {odometry_at(1.0, 0.0)};
    for (int i = 1; i <= 6; ++i) objects.push_back(image_at(1.0 + 0.01 * i));
    objects.push_back(odometry_at(1.1, 0.0));
    EXPECT_EQ(read(objects).order(), "wfffwfff");
}

TEST(Readings, FieldsBeforeAnImageThatCannotBeUsedAreHandedOut) {
    auto without_calibration = image_at(1.04);
    without_calibration->cameraParams = {};
    const auto file = test_folder() / "input.rawlog";
    write_bytes(file, gz(serialized({odometry_at(1.0, 0.0), image_at(1.02), without_calibration})));
    RawlogReader reader(file);
    FieldSource source(reader, {});
    EXPECT_TRUE(source.next());
    const auto field = source.next();
    ASSERT_TRUE(field);
    EXPECT_TRUE(std::holds_alternative<Field>(*field));
    EXPECT_THROW(source.next(), config::ConfigError);
}

TEST(Readings, AnImuIsAGyroAboutTheUpwardAxisOfTheRobot) {
    auto upside_down = gyro_at(1.0, 0.25);
    upside_down->sensorPose = mrpt::poses::CPose3D(0.1, 0, 0.2, 0, 0, 180 * degree_rad);
    const auto turned_over = read({upside_down}).gyro();
    ASSERT_EQ(turned_over.size(), 1U);
    EXPECT_NEAR(turned_over[0].omega_radps, -0.25, 1e-12);
    auto on_its_side = gyro_at(1.0, 0.0);
    on_its_side->set(mrpt::obs::IMU_WY, 0.5);  // y looks up
    on_its_side->sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, 0, 90 * degree_rad);
    EXPECT_NEAR(read({on_its_side}).gyro().at(0).omega_radps, 0.5, 1e-12);
    EXPECT_NEAR(read({gyro_at(1.0, 0.25)}).gyro().at(0).omega_radps, 0.25, 1e-12);
}

TEST(Readings, OnlyTheFirstGyroCounts) {
    const Events events = read({gyro_at(1.0, 0.1, "A"), gyro_at(1.0, 9.0, "B"), gyro_at(1.1, 0.2, "A")});
    ASSERT_EQ(events.gyro().size(), 2U);
    EXPECT_EQ(events.counts.gyro, 2U);
    EXPECT_EQ(events.counts.ignored, 1U);
}

TEST(Readings, AnImuWithoutTurnRateIsIgnored) {
    auto accelerometer = mrpt::obs::CObservationIMU::Create();
    accelerometer->timestamp = mrpt::Clock::fromDouble(1.0);
    accelerometer->set(mrpt::obs::IMU_X_ACC, 9.0);
    const Events events = read({accelerometer, gyro_at(1.1, 0.1, "other")});
    EXPECT_EQ(events.gyro().size(), 1U);
    EXPECT_EQ(events.counts.ignored, 1U);
}

TEST(Readings, AGyroReadingThatIsNoNumberOrNotLaterIsRejected) {
    const Events events = read({gyro_at(1.0, 0.1), gyro_at(1.1, std::nan("")), gyro_at(1.0, 0.1),
                                gyro_at(0.9, 0.1), gyro_at(1.2, 0.1)});
    EXPECT_EQ(events.gyro().size(), 2U);
    EXPECT_EQ(events.counts.rejected.at("gyro_not_finite"), 1U);
    EXPECT_EQ(events.counts.rejected.at("gyro_time_repeated"), 1U);
    EXPECT_EQ(events.counts.rejected.at("gyro_time_backwards"), 1U);
}

}  // namespace
}  // namespace flownav::io
