#include "flownav/io/flow_obstacle_sensor.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <map>

#include "flownav/config/make_state.h"
#include "flownav/io/field_source.h"
#include "flownav/io/observations.h"
#include "flownav/testing/write_scene.h"
#include "producer_samples.h"

namespace flownav::io {
namespace {

using namespace flownav::testing;
using mrpt::hwdrivers::CGenericSensor;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationComment;
using mrpt::obs::CObservationImage;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CObservationPointCloud;
namespace fs = std::filesystem;

/// A drive of 24 images, rendered once, in a folder of the first test that calls it, because tests run in
/// parallel.
const fs::path& drive() {
    static const fs::path file = [] {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        const fs::path folder = fs::path(::testing::TempDir()) / "flownav_producer_drive" / test->name();
        fs::create_directories(folder);
        SceneOptions options;
        options.images = 24;
        options.camera = standard_camera(320, 240);
        write_scene(make_scene(options), folder / "drive");
        return folder / "drive.rawlog";
    }();
    return file;
}

std::string rawlog_lines(const fs::path& file = drive()) {
    return "grabber_type = rawlog\nrawlog_file = " + file.string() + "\nend_wait_s = 0\n";
}

void configure(CFlowObstacleSensor& sensor, const std::string& lines) {
    sensor.setMinLoggingLevel(mrpt::system::LVL_ERROR);
    const mrpt::config::CConfigFileMemory ini("[FLOW]\nprocess_rate = 100\n" + lines);
    sensor.loadConfig(ini, "FLOW");
}

/// Observations of a sensor that ran until it threw.
struct Grab {
    std::vector<CObservation::Ptr> observations;
    std::string reason;
    bool regular_end = false;

    std::map<std::string, int> counts() const {
        std::map<std::string, int> counts;
        for (const auto& observation : observations) ++counts[observation->sensorLabel];
        return counts;
    }
    template <class Class>
    std::vector<std::shared_ptr<Class>> labelled(const std::string& label) const {
        std::vector<std::shared_ptr<Class>> found;
        for (const auto& observation : observations) {
            auto wanted = std::dynamic_pointer_cast<Class>(observation);
            if (wanted && observation->sensorLabel == label) found.push_back(wanted);
        }
        return found;
    }
};

void collect(CGenericSensor& sensor, Grab& grab) {
    for (const auto& [time, object] : sensor.getObservations())
        grab.observations.push_back(std::dynamic_pointer_cast<CObservation>(object));
}

Grab grab(CFlowObstacleSensor& sensor) {
    Grab grab;
    sensor.initialize();
    EXPECT_EQ(sensor.getState(), CGenericSensor::ssWorking);
    try {
        for (int calls = 0; calls < 10000; ++calls) {
            sensor.doProcess();
            collect(sensor, grab);
        }
    } catch (const EndOfInput& end) {
        grab.reason = end.what();
        grab.regular_end = true;
    } catch (const std::exception& error) {
        grab.reason = error.what();
    }
    return grab;
}

Grab grab_with(const std::string& lines) {
    CFlowObstacleSensor sensor;
    configure(sensor, lines);
    return grab(sensor);
}

/// The steps of a rawlog as flownav-replay makes them.
std::vector<pipeline::Step> replayed(const fs::path& file) {
    const config::Config config;
    RawlogReader reader(file);
    FieldSource source(reader, config.camera);
    pipeline::State state = config::make_state(config);
    std::vector<pipeline::Step> steps;
    while (const auto event = source.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) steps.push_back(pipeline::step(state, *field));
    }
    return steps;
}

TEST(FlowObstacleSensor, GivesTheNumbersOfAReplay) {
    const Grab grab = grab_with(rawlog_lines());
    EXPECT_TRUE(grab.regular_end) << grab.reason;
    const auto odometry = grab.labelled<CObservationOdometry>("FLOW_ODOMETRY");
    const auto scans = grab.labelled<CObservation2DRangeScan>("FLOW_SCAN");
    const auto clouds = grab.labelled<CObservationPointCloud>("FLOW_POINTS");
    const auto steps = replayed(drive());
    ASSERT_EQ(odometry.size(), steps.size());
    std::size_t cycle = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto expected = odometry_observation(steps[i]);
        EXPECT_EQ(odometry[i]->timestamp, expected->timestamp);
        EXPECT_EQ(odometry[i]->odometry, expected->odometry);
        EXPECT_EQ(odometry[i]->hasVelocities, expected->hasVelocities);
        EXPECT_EQ(odometry[i]->velocityLocal, expected->velocityLocal);
        if (!steps[i].end_of_cycle) continue;
        ASSERT_LT(cycle, scans.size());
        const auto scan = scan_observation(steps[i], config::Config{}.pipeline.obstacles.range_max_m);
        ASSERT_EQ(scans[cycle]->getScanSize(), scan->getScanSize());
        for (std::size_t beam = 0; beam < scan->getScanSize(); ++beam) {
            EXPECT_EQ(scans[cycle]->getScanRange(beam), scan->getScanRange(beam));
            EXPECT_EQ(scans[cycle]->getScanRangeValidity(beam), scan->getScanRangeValidity(beam));
        }
        EXPECT_EQ(clouds[cycle]->pointcloud->size(), steps[i].obstacles.size());
        ++cycle;
    }
    EXPECT_GE(cycle, 2U);
    EXPECT_EQ(scans.size(), cycle);
    EXPECT_EQ(clouds.size(), cycle);
}

TEST(FlowObstacleSensor, CopiesTheOdometryOfARawlogWhenAsked) {
    EXPECT_EQ(grab_with(rawlog_lines()).counts()["ODOMETRY"], 24);
    EXPECT_EQ(grab_with(rawlog_lines() + "use_odometry = false\n").counts().count("ODOMETRY"), 0U);
}

TEST(FlowObstacleSensor, PublishesTheFieldsWithTheirCalibrationWhenAsked) {
    EXPECT_EQ(grab_with(rawlog_lines()).counts().count("CAMERA1"), 0U);
    const Grab grab = grab_with(rawlog_lines() + "publish_image = true\ncamera.height_m = 0.91\n");
    const auto images = grab.labelled<CObservationImage>("CAMERA1");
    ASSERT_EQ(images.size(), 24U);
    EXPECT_EQ(images[0]->image.getWidth(), 320U);
    EXPECT_NEAR(images[0]->cameraPose.z(), 0.91, 1e-6);
    EXPECT_GT(images[0]->cameraParams.fx(), 1.0);
}

TEST(FlowObstacleSensor, LabelsBeginWithThePrefix) {
    const auto counts = grab_with(rawlog_lines() + "label_prefix = REAR\n").counts();
    EXPECT_EQ(counts.at("REAR_ODOMETRY"), 24);
    EXPECT_GE(counts.at("REAR_SCAN"), 2);
    EXPECT_GE(counts.at("REAR_POINTS"), 2);
    EXPECT_EQ(counts.count("FLOW_ODOMETRY"), 0U);
}

TEST(FlowObstacleSensor, EndsARawlogWithACommentAfterEverythingElse) {
    const Grab grab = grab_with(rawlog_lines());
    ASSERT_FALSE(grab.observations.empty());
    const auto last = std::dynamic_pointer_cast<CObservationComment>(grab.observations.back());
    ASSERT_TRUE(last);
    EXPECT_EQ(last->sensorLabel, "FLOW_END");
    EXPECT_TRUE(says(last->text, "read to its end: 24 fields"));
    for (const auto& observation : grab.observations) EXPECT_LE(observation->timestamp, last->timestamp);
}

TEST(FlowObstacleSensor, WaitsAfterTheEndAsLongAsItWasTold) {
    CFlowObstacleSensor sensor;
    configure(sensor, rawlog_lines() + "end_wait_s = 0.2\n");
    sensor.initialize();
    while (!sensor.ended()) sensor.doProcess();
    EXPECT_EQ(sensor.getState(), CGenericSensor::ssWorking);
    for (int call = 1; call < 20; ++call) EXPECT_NO_THROW(sensor.doProcess()) << call;  // 0.2 s at 100 Hz
    EXPECT_THROW(sensor.doProcess(), EndOfInput);
    EXPECT_EQ(sensor.getState(), CGenericSensor::ssError);
    EXPECT_EQ(sensor.error(), "");
}

TEST(FlowObstacleSensor, ADamagedRawlogGivesWhatItHoldsThenAnErrorState) {
    const fs::path damaged = producer_folder() / "damaged.rawlog";
    fs::copy_file(drive(), damaged);
    fs::resize_file(damaged, fs::file_size(damaged) / 2);
    CFlowObstacleSensor sensor;
    configure(sensor, rawlog_lines(damaged));
    std::string logged;
    sensor.logRegisterCallback([&](std::string_view text, mrpt::system::VerbosityLevel level,
                                   std::string_view, mrpt::Clock::time_point) {
        if (level == mrpt::system::LVL_ERROR) logged += text;
    });
    Grab result = grab(sensor);
    EXPECT_FALSE(result.regular_end);
    EXPECT_TRUE(says(result.reason, "damaged.rawlog"));
    EXPECT_TRUE(says(logged, "damaged.rawlog"));
    EXPECT_EQ(sensor.getState(), CGenericSensor::ssError);
    EXPECT_GE(result.counts()["FLOW_ODOMETRY"], 8);
    EXPECT_LT(result.counts()["FLOW_ODOMETRY"], 24);
    EXPECT_EQ(result.counts()["FLOW_END"], 1);
}

TEST(FlowObstacleSensor, AnErrorStateComesAtOnceAndTheExceptionAfterTheWait) {
    const fs::path damaged = producer_folder() / "damaged.rawlog";
    fs::copy_file(drive(), damaged);
    fs::resize_file(damaged, fs::file_size(damaged) / 2);
    CFlowObstacleSensor sensor;
    configure(sensor, rawlog_lines(damaged) + "end_wait_s = 0.05\n");
    sensor.setMinLoggingLevel(mrpt::system::LVL_ERROR);
    sensor.logging_enable_console_output = false;
    sensor.initialize();
    while (sensor.getState() == CGenericSensor::ssWorking) sensor.doProcess();
    for (int call = 1; call < 5; ++call) EXPECT_NO_THROW(sensor.doProcess());
    EXPECT_ANY_THROW(sensor.doProcess());
}

TEST(FlowObstacleSensor, WhatCannotBeOpenedIsAnErrorStateWithAMessage) {
    CFlowObstacleSensor sensor;
    configure(sensor, rawlog_lines("none.rawlog"));
    sensor.logging_enable_console_output = false;
    try {
        sensor.initialize();
        FAIL() << "it was opened";
    } catch (const std::exception& error) {
        EXPECT_TRUE(says(error.what(), "none.rawlog: no such file"));
    }
    EXPECT_EQ(sensor.getState(), CGenericSensor::ssError);
}

TEST(FlowObstacleSensor, ARawlogWithoutImagesOfTheLabelSaysWhatThereIs) {
    CFlowObstacleSensor sensor;
    configure(sensor, rawlog_lines() + "camera.camera_label = FRONT\n");
    sensor.logging_enable_console_output = false;
    const Grab result = grab(sensor);
    EXPECT_TRUE(says(result.reason, "no image labelled FRONT"));
    EXPECT_TRUE(says(result.reason, "CAMERA1"));
}

TEST(FlowObstacleSensor, BadKeysAreRefusedAtLoading) {
    CFlowObstacleSensor sensor;
    try {
        configure(sensor, rawlog_lines() + "tau_px = 3\n");
        FAIL() << "an unknown key was taken";
    } catch (const std::exception& error) {  // MRPT wraps the exception
        EXPECT_TRUE(says(error.what(), "section FLOW", "tau_px", "obstacles.tau_px"));
    }
    EXPECT_EQ(sensor.getState(), CGenericSensor::ssError);
}

/// Sets MRPT's clock to the time of the test.
class SimulatedClock {
  public:
    explicit SimulatedClock(double start_s) : now_s_(start_s) {
        mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
        advance(0);
    }
    ~SimulatedClock() { mrpt::Clock::setActiveClock(mrpt::Clock::Realtime); }
    SimulatedClock(const SimulatedClock&) = delete;
    SimulatedClock& operator=(const SimulatedClock&) = delete;

    void advance(double by_s) {
        now_s_ += by_s;
        mrpt::Clock::setSimulatedTime(mrpt::Clock::fromDouble(now_s_));
    }

  private:
    double now_s_;
};

TEST(FlowObstacleSensor, PacedFieldsComeWhenTheyAreDue) {
    SimulatedClock clock(2e9);
    CFlowObstacleSensor sensor;
    configure(sensor, rawlog_lines() + "paced = true\nuse_odometry = false\n");  // 25 images a second
    sensor.initialize();
    const auto fields = [&] {
        Grab grab;
        sensor.doProcess();
        collect(sensor, grab);
        return grab.counts()["FLOW_ODOMETRY"];
    };
    EXPECT_EQ(fields(), 1);
    EXPECT_EQ(fields(), 0);
    clock.advance(0.03);
    EXPECT_EQ(fields(), 0);
    clock.advance(0.02);
    EXPECT_EQ(fields(), 1);
    EXPECT_EQ(fields(), 0);
    clock.advance(0.1);
    EXPECT_EQ(fields(), 1);
    EXPECT_EQ(fields(), 1);
    EXPECT_EQ(fields(), 0);
}

TEST(FlowObstacleSensor, IsMadeByTheNameOfItsDriver) {
    CFlowObstacleSensor::doRegister();
    EXPECT_TRUE(CGenericSensor::createSensorPtr("CFlowObstacleSensor"));
}

}  // namespace
}  // namespace flownav::io
