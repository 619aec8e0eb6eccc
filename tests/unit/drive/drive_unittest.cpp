#include "flownav/drive/drive.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>

#include "flownav/sim/vehicle.h"

namespace flownav::drive {
namespace {

using Eigen::Vector2d;

/// A clock that advances in wait_until_s() only.
class VirtualClock : public Clock {
  public:
    double now_s() const override { return now_s_; }
    void wait_until_s(double time_s) override { now_s_ = time_s; }

  private:
    double now_s_ = 100.0;
};

/// A robot that follows its commands exactly, without a world.
class IdealBase : public nav::RobotBase {
  public:
    IdealBase(const RobotModel& robot, const VirtualClock& clock) : vehicle_(robot, {}), clock_(clock) {}

    std::optional<nav::WheelReading> odometry() override {
        if (clock_.now_s() > lost_at_s) throw nav::RobotError("the base is lost");
        vehicle_.advance(clock_.now_s());
        nav::WheelReading reading{clock_.now_s(), vehicle_.pose(), vehicle_.motion()};
        if (clock_.now_s() > future_at_s) {
            reading.time_s += 1000.0;
            future_at_s = 1e9;
        }
        if (clock_.now_s() > nonsense_from_s) reading.T_odom_robot.x_m = std::nan("");
        return reading;
    }
    void drive(const MotionCommand& command) override { vehicle_.command(clock_.now_s(), command); }
    void stop() override {
        if (++stops == 1) stopped_.set_value();
    }
    std::future<void> first_stop() { return stopped_.get_future(); }

    const sim::Vehicle& vehicle() const { return vehicle_; }

    double lost_at_s = 1e9;
    double nonsense_from_s = 1e9;
    double future_at_s = 1e9;  ///< time at which one reading has a future time stamp
    std::atomic<int> stops{0};

  private:
    std::promise<void> stopped_;
    sim::Vehicle vehicle_;
    const VirtualClock& clock_;
};

/// Reports free ground all around, ten times a second, until it ends.
class FreeGround : public SensorFeed {
  public:
    explicit FreeGround(const VirtualClock& clock) : clock_(clock) {}

    std::vector<nav::SensorUpdate> arrived() override {
        if (clock_.now_s() < next_s_ || clock_.now_s() > blind_at_s) return {};
        next_s_ = clock_.now_s() + 0.1;
        nav::SensorUpdate update;
        update.by_camera = false;
        update.report.timestamp_s = clock_.now_s() + ahead_s;
        if (clock_.now_s() > future_at_s) {
            update.report.timestamp_s += 1000.0;
            future_at_s = 1e9;
        }
        update.report.end_of_cycle = true;
        update.ground.push_back({{-1.0, 0.0}, {5.0, 0.0}, 4.0});
        return {update};
    }
    std::string end() override { return clock_.now_s() > ends_at_s ? "the camera was unplugged" : ""; }

    double blind_at_s = 1e9;
    double ends_at_s = 1e9;
    double future_at_s = 1e9;  ///< time at which one scan has a future time stamp
    double ahead_s = 0.0;  ///< of every time stamp

  private:
    const VirtualClock& clock_;
    double next_s_ = 0.0;
};

/// Drives an ideal base, two metres ahead and half a metre to the left.
class RobotDrive : public ::testing::Test {
  protected:
    RobotDrive() : base_(options_.config.navigation.robot, clock_), feed_(clock_) {
        options_.goals_m = {{2.0, 0.5}};
        options_.config.guard.needs_fields = false;
        options_.timeout_s = 60.0;
    }

    DriveResult run() { return run(feed_); }
    DriveResult run(SensorFeed& feed) { return drive(options_, {clock_, base_, feed}, nobody_); }

    VirtualClock clock_;
    DriveOptions options_;
    IdealBase base_;
    FreeGround feed_;
    DriveObserver nobody_;
};

TEST_F(RobotDrive, ReachesItsGoalAndIsToldToStop) {
    const DriveResult result = run();
    EXPECT_EQ(result.outcome, Outcome::Reached);
    EXPECT_LT((Vector2d(base_.vehicle().pose().x_m, base_.vehicle().pose().y_m) - options_.goals_m[0]).norm(),
              0.35);
    EXPECT_EQ(base_.stops, 1);
}

TEST_F(RobotDrive, AGoalIsInTheFrameOfTheStart) {
    options_.start = {10.0, 5.0, M_PI / 2};
    options_.goals_m = {{9.5, 7.0}};  // the goal of the fixture, relative to this start
    EXPECT_EQ(run().outcome, Outcome::Reached);
    EXPECT_NEAR(base_.vehicle().pose().x_m, 2.0, 0.35);
    EXPECT_NEAR(base_.vehicle().pose().y_m, 0.5, 0.35);
}

TEST_F(RobotDrive, ASensorThatFallsSilentStopsTheRobotUntilTheTimeIsOver) {
    feed_.blind_at_s = 102.0;
    const DriveResult result = run();
    EXPECT_EQ(result.outcome, Outcome::Timeout);
    EXPECT_EQ(base_.vehicle().motion().v_mps, 0.0);
    ASSERT_FALSE(result.stops.empty());
    EXPECT_EQ(result.stops.back().reason, nav::GuardReason::SensorStale);
}

TEST_F(RobotDrive, TheGuardsKeysReachTheGuard) {
    config::set_config_value(options_.config, "guard.map_stale_s", "0.1");
    options_.timeout_s = 2.0;
    feed_.blind_at_s = 100.5;
    const DriveResult result = run();
    ASSERT_FALSE(result.stops.empty());
    EXPECT_EQ(result.stops.back().reason, nav::GuardReason::SensorStale);
    EXPECT_LT(result.stops.back().time_s, 0.8);  // 1.5 s later with the default
}

TEST_F(RobotDrive, TheKeyOfTimeStampsInTheFutureHoldsForScans) {
    options_.timeout_s = 3.0;
    feed_.ahead_s = 2.0;
    config::set_config_value(options_.config, "guard.future_max_s", "1");
    EXPECT_EQ(run().path_m, 0.0);
    config::set_config_value(options_.config, "guard.future_max_s", "5");
    EXPECT_GT(run().path_m, 0.1);
}

TEST_F(RobotDrive, ACameraThatEndsEndsTheDrive) {
    feed_.ends_at_s = 101.0;
    const DriveResult result = run();
    EXPECT_EQ(result.outcome, Outcome::Lost);
    EXPECT_EQ(result.why, "the camera was unplugged");
    EXPECT_NEAR(result.time_s, 1.0, 0.1);
    EXPECT_EQ(base_.stops, 1);
}

TEST_F(RobotDrive, ALostBaseEndsTheDriveAndIsStillToldToStop) {
    base_.lost_at_s = 101.0;
    const DriveResult result = run();
    EXPECT_EQ(result.outcome, Outcome::Lost);
    EXPECT_EQ(result.why, "the base is lost");
    EXPECT_GT(result.samples.size(), 40U);  // earlier samples are kept
    EXPECT_EQ(base_.stops, 1);
}

TEST_F(RobotDrive, AFeedThatThrowsEndsTheDriveAndTheRobotStops) {
    class Broken : public SensorFeed {
      public:
        std::vector<nav::SensorUpdate> arrived() override { throw std::runtime_error("out of memory"); }
        std::string end() override { return ""; }
    } broken;
    const DriveResult result = run(broken);
    EXPECT_EQ(result.outcome, Outcome::Lost);
    EXPECT_EQ(result.why, "out of memory");
    EXPECT_EQ(base_.stops, 1);
}

TEST_F(RobotDrive, AnObserverThatThrowsEndsTheDriveAndTheRobotStops) {
    class Broken : public DriveObserver {
      public:
        void on_tick(const DriveSample& sample) override {
            if (sample.time_s > 1.0) throw std::runtime_error("the disk is gone");
        }
    } broken;
    const DriveResult result = drive(options_, {clock_, base_, feed_}, broken);
    EXPECT_EQ(result.why, "the disk is gone");
    EXPECT_EQ(base_.stops, 1);
}

TEST_F(RobotDrive, BeingToldToStopEndsItInTheSameTick) {
    options_.stop_wanted = [this] { return clock_.now_s() >= 101.0; };
    const DriveResult result = run();
    EXPECT_EQ(result.outcome, Outcome::Stopped);
    EXPECT_NEAR(result.time_s, 1.0, 0.021);
    EXPECT_EQ(base_.stops, 1);
}

TEST_F(RobotDrive, TimesOfSamplesAndStopsCountFromTheStartOfTheDrive) {
    feed_.blind_at_s = 102.0;
    options_.timeout_s = 8.0;
    const DriveResult result = run();
    EXPECT_NEAR(result.time_s, 8.0, 0.021);
    EXPECT_EQ(result.samples.front().time_s, 0.0);
    EXPECT_FALSE(result.samples.front().truth_known);
    EXPECT_GT(result.path_m, 0.1);
    ASSERT_FALSE(result.stops.empty());
    for (const nav::GuardEvent& stop : result.stops) EXPECT_LE(stop.time_s, 8.1);
}

TEST_F(RobotDrive, OptionsThatMakeNoSenseThrowBeforeTheRobotMoves) {
    options_.config.map.size_m = 1.0;
    EXPECT_THROW(run(), std::invalid_argument);
    EXPECT_EQ(base_.vehicle().motion().v_mps, 0.0);
}

TEST_F(RobotDrive, ReadingsThatAreNoNumbersAreSilenceAndStopTheRobot) {
    base_.nonsense_from_s = 101.0;
    options_.timeout_s = 5.0;
    const DriveResult result = run();
    EXPECT_EQ(result.outcome, Outcome::Timeout);
    EXPECT_TRUE(std::isfinite(result.path_m));
    ASSERT_FALSE(result.stops.empty());
    EXPECT_EQ(result.stops.back().reason, nav::GuardReason::OdometryContradiction);
    EXPECT_EQ(base_.vehicle().motion().v_mps, 0.0);
}

TEST_F(RobotDrive, OneReadingFromTheFutureIsLeftOutAndTheRobotArrives) {
    base_.future_at_s = 101.0;
    const DriveResult result = run();
    EXPECT_EQ(result.outcome, Outcome::Reached);
    EXPECT_NEAR(base_.vehicle().pose().x_m, 2.0, 0.35);
}

TEST_F(RobotDrive, AScanFromTheFutureIsLeftOutAndTheRobotArrives) {
    feed_.future_at_s = 101.0;
    EXPECT_EQ(run().outcome, Outcome::Reached);
}

/// Hangs until the base is told to stop.
class HungFeed : public SensorFeed {
  public:
    explicit HungFeed(IdealBase& base) : stopped_(base.first_stop()) {}

    std::vector<nav::SensorUpdate> arrived() override {
        woken_ = stopped_.wait_for(std::chrono::seconds(60)) == std::future_status::ready;
        return {};
    }
    std::string end() override { return woken_ ? "told to stop" : "forgotten"; }

  private:
    std::future<void> stopped_;
    bool woken_ = false;
};

TEST_F(RobotDrive, TheWatchdogStopsARobotWhoseProgramHangs) {
    HungFeed feed(base_);
    options_.hung_s = 1.0;
    EXPECT_EQ(run(feed).why, "told to stop");
}

}  // namespace
}  // namespace flownav::drive
