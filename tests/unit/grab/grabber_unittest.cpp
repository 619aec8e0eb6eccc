#include "grabber.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationComment.h>

#include <fstream>

#include "flownav/cli/usage_error.h"
#include "flownav/io/rawlog_reader.h"
#include "grab_samples.h"

namespace flownav {

/// Observes a comment per turn, `turns` times, then fails.
class CTalkingSensor : public mrpt::hwdrivers::CGenericSensor {
    DEFINE_GENERIC_SENSOR(CTalkingSensor)
  public:
    void doProcess() override {
        if (turn_++ == turns_) throw std::runtime_error("nothing more to say");
        auto comment = mrpt::obs::CObservationComment::Create();
        comment->timestamp = mrpt::Clock::now();
        comment->text = std::to_string(turn_);
        appendObservation(comment);
    }

  protected:
    void loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini,
                                   const std::string& section) override {
        turns_ = ini.read_int(section, "turns", 1, true);
    }

  private:
    int turns_ = 0;
    int turn_ = 0;
};

}  // namespace flownav

IMPLEMENTS_GENERIC_SENSOR(CTalkingSensor, flownav)

namespace flownav {
namespace {

class GrabberOf : public ::testing::Test {
  protected:
    GrabSetup setup(const std::string& ini) {
        CTalkingSensor::doRegister();
        std::ofstream(folder / "grab.ini") << ini;
        return read_grab_setup(folder / "grab.ini");
    }
    GrabOptions options() const {
        GrabOptions options;
        options.recording.file = folder / "f.rawlog";
        return options;
    }
    const std::filesystem::path folder = testing::grab_test_folder();
};

TEST_F(GrabberOf, ASensorThatFailsEndsItAndAllOfItIsThere) {
    Grabber grabber(setup("[X]\ndriver = CTalkingSensor\nprocess_rate = 1000\nturns = 25\n"), options());
    while (!grabber.done()) std::this_thread::yield();
    const GrabResult result = grabber.finish();
    EXPECT_EQ(result.status, GrabStatus::Sensor);
    EXPECT_FALSE(result.hanging);
    ASSERT_EQ(result.messages.size(), 1U);
    EXPECT_EQ(result.messages[0], "sensor X: nothing more to say");
    io::RawlogReader reader(folder / "f.rawlog");
    int count = 0;
    while (const auto observation = reader.next()) {
        const auto comment = std::dynamic_pointer_cast<mrpt::obs::CObservationComment>(observation);
        ASSERT_TRUE(comment);
        EXPECT_EQ(comment->text, std::to_string(++count));
    }
    EXPECT_EQ(count, 25);
    EXPECT_EQ(reader.end().kind, io::ReadEnd::Kind::Clean);
}

TEST_F(GrabberOf, WhatADriverMissesIsAUsageErrorThatNamesTheSection) {
    try {
        setup("[X]\ndriver = CTalkingSensor\nprocess_rate = 1000\n");
        FAIL() << "turns is missing";
    } catch (const cli::UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("[X]: "), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("turns"), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

TEST_F(GrabberOf, GlobalKeysAreFollowed) {
    const GrabSetup read = setup(
        "[global]\nrawlog_GZ_compress_level = 7\ntime_between_launches = 250\nuse_sensoryframes = true\n"
        "[X]\ndriver = CTalkingSensor\nprocess_rate = 1\nturns = 2\n"
        "[Y]\nrawlog-grabber-ignore = true\n");
    EXPECT_EQ(read.gz_level, 7);
    EXPECT_EQ(read.time_between_launches_s, 0.25);
    EXPECT_EQ(read.warnings.size(), 1U);
    ASSERT_EQ(read.sensors.size(), 1U);
    EXPECT_EQ(read.sensors[0].section, "X");
}

}  // namespace
}  // namespace flownav
