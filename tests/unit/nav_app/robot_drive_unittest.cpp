#include "robot_drive.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>

#include "flownav/sim/vehicle.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

/// A clock that only moves when somebody waits.
struct VirtualClock {
    double now_s = 100.0;
};

/// A robot that does what it is told, in no world at all.
class IdealBase : public nav::RobotBase {
  public:
    IdealBase(const RobotModel& robot, const VirtualClock& clock) : vehicle_(robot, {}), clock_(clock) {}

    std::optional<nav::WheelReading> odometry() override {
        if (clock_.now_s > lost_at_s) throw nav::RobotError("the base is lost");
        vehicle_.advance(clock_.now_s);
        return nav::WheelReading{clock_.now_s, vehicle_.pose(), vehicle_.motion()};
    }
    void drive(const MotionCommand& command) override { vehicle_.command(clock_.now_s, command); }
    void stop() override {
        if (++stops == 1) stopped_.set_value();
    }
    std::future<void> first_stop() { return stopped_.get_future(); }

    const sim::Vehicle& vehicle() const { return vehicle_; }

    double lost_at_s = 1e9;
    std::atomic<int> stops{0};

  private:
    std::promise<void> stopped_;
    sim::Vehicle vehicle_;
    const VirtualClock& clock_;
};

/// Sees free ground all around, ten times a second, until it ends.
class FreeGround : public SensorFeed {
  public:
    explicit FreeGround(const VirtualClock& clock) : clock_(clock) {}

    std::vector<nav::Sensed> arrived() override {
        if (clock_.now_s < next_s_ || clock_.now_s > blind_at_s) return {};
        next_s_ = clock_.now_s + 0.1;
        nav::Sensed sensed;
        sensed.by_camera = false;
        sensed.report.timestamp_s = clock_.now_s;
        sensed.report.end_of_cycle = true;
        sensed.ground.push_back({{-1.0, 0.0}, {5.0, 0.0}, 4.0});
        return {sensed};
    }
    std::string end() override { return clock_.now_s > ends_at_s ? "the camera was unplugged" : ""; }

    double blind_at_s = 1e9;
    double ends_at_s = 1e9;

  private:
    const VirtualClock& clock_;
    double next_s_ = 0.0;
};

class RobotDrive : public ::testing::Test {
  protected:
    RobotDrive() : base_(options_.config.navigation.robot, clock_), feed_(clock_) {
        options_.goals_m = {{2.0, 0.5}};
        options_.guard.needs_fields = false;
        options_.timeout_s = 60.0;
        options_.clock_s = [this] { return clock_.now_s; };
        options_.wait_until_s = [this](double time_s) { clock_.now_s = time_s; };
    }

    VirtualClock clock_;
    RobotDriveOptions options_;
    IdealBase base_;
    FreeGround feed_;
};

TEST_F(RobotDrive, ReachesItsGoalAndIsToldToStop) {
    const RobotDriveResult result = drive_robot(options_, base_, feed_);
    EXPECT_EQ(result.outcome, Outcome::Reached);
    EXPECT_LT((Vector2d(base_.vehicle().pose().x_m, base_.vehicle().pose().y_m) - options_.goals_m[0]).norm(),
              0.35);
    EXPECT_EQ(base_.stops, 1);
}

TEST_F(RobotDrive, AGoalIsInTheFrameOfTheStart) {
    options_.start = {10.0, 5.0, M_PI / 2};
    options_.goals_m = {{9.5, 7.0}};  // the same place as seen from there
    EXPECT_EQ(drive_robot(options_, base_, feed_).outcome, Outcome::Reached);
    EXPECT_NEAR(base_.vehicle().pose().x_m, 2.0, 0.35);
    EXPECT_NEAR(base_.vehicle().pose().y_m, 0.5, 0.35);
}

TEST_F(RobotDrive, ASensorThatFallsSilentStopsTheRobotUntilTheTimeIsOver) {
    feed_.blind_at_s = 102.0;
    const RobotDriveResult result = drive_robot(options_, base_, feed_);
    EXPECT_EQ(result.outcome, Outcome::Timeout);
    EXPECT_EQ(base_.vehicle().motion().v_mps, 0.0);
    ASSERT_FALSE(result.stops.empty());
    EXPECT_EQ(result.stops.back().reason, nav::GuardReason::SensorStale);
}

TEST_F(RobotDrive, ACameraThatEndsEndsTheDrive) {
    feed_.ends_at_s = 101.0;
    const RobotDriveResult result = drive_robot(options_, base_, feed_);
    EXPECT_EQ(result.outcome, Outcome::Timeout);
    EXPECT_EQ(result.why, "the camera was unplugged");
    EXPECT_NEAR(result.time_s, 1.0, 0.1);
    EXPECT_EQ(base_.stops, 1);
}

TEST_F(RobotDrive, ALostBaseIsAnErrorAndStillToldToStop) {
    base_.lost_at_s = 101.0;
    EXPECT_THROW(drive_robot(options_, base_, feed_), nav::RobotError);
    EXPECT_EQ(base_.stops, 1);
}

/// Hangs until the base is told to stop.
class HungFeed : public SensorFeed {
  public:
    explicit HungFeed(IdealBase& base) : stopped_(base.first_stop()) {}

    std::vector<nav::Sensed> arrived() override {
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
    EXPECT_EQ(drive_robot(options_, base_, feed).why, "told to stop");
}

}  // namespace
}  // namespace flownav
