#include "flownav/nav/recovery_manager.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "flownav/nav/collision_checker.h"
#include "flownav/nav/motion_model.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

/// Drives straight at the way point; reports to be stuck while `stuck_` is set.
class SimpleNavigator : public Navigator {
  public:
    explicit SimpleNavigator(const bool& stuck) : stuck_(stuck) {}

    Decision decide(const Situation& situation, const Vector2d& waypoint_m) override {
        Decision decision;
        decision.stuck = stuck_;
        if (stuck_) return decision;
        const Vector2d p = transform(inverse(situation.T_map_robot), waypoint_m);
        decision.command = {0.4, 2.0 * std::atan2(p.y(), p.x())};
        return decision;
    }

  private:
    const bool& stuck_;
};

/// A robot that follows its commands at once, on free maps.
class Pilots : public ::testing::Test {
  protected:
    Pilots() {
        map_.fill(0.9F);
        local_.fill(0.9F);
    }

    RecoveryManager make(const RecoveryParams& params, const std::vector<Vector2d>& goals) {
        return {RobotModel(), params, std::make_unique<SimpleNavigator>(stuck_), goals};
    }

    RecoveryDecision step(RecoveryManager& recovery) {
        const Situation situation{time_s_, pose_, motion_, &local_, true};
        const RecoveryDecision decision = recovery.decide(situation, map_);
        motion_ = decision.command;
        pose_ = compose(pose_, pose_after(motion_, 0.2));
        time_s_ += 0.2;
        return decision;
    }

    /// Steps until the state changes, at most for `longest_s`.
    RecoveryState next_state(RecoveryManager& recovery, double longest_s = 30.0) {
        const double until_s = time_s_ + longest_s;
        const RecoveryState before = state_;
        while (time_s_ < until_s && state_ == before) state_ = step(recovery).state;
        return state_;
    }

    COccupancyGridMap2D map_{-10.0F, 10.0F, -10.0F, 10.0F, 0.1F};
    COccupancyGridMap2D local_{-5.0F, 5.0F, -5.0F, 5.0F, 0.1F};
    Pose2 pose_;
    MotionCommand motion_;
    double time_s_ = 0.0;
    bool stuck_ = false;
    RecoveryState state_ = RecoveryState::Driving;
};

TEST_F(Pilots, DriveToTheGoalAndStandThere) {
    RecoveryManager recovery = make({}, {{3.0, 2.0}});
    EXPECT_EQ(next_state(recovery), RecoveryState::Arrived);
    EXPECT_LT((Vector2d(pose_.x_m, pose_.y_m) - Vector2d(3.0, 2.0)).norm(), 0.3);
    EXPECT_EQ(step(recovery).command.v_mps, 0.0);
}

TEST_F(Pilots, VisitWayPointsInTheirOrder) {
    RecoveryManager recovery = make({}, {{2.0, 1.0}, {2.0, -1.0}, {4.0, 0.0}});
    bool last = false;
    for (int i = 0; i < 150 && !last; ++i) last = step(recovery).last_goal;
    EXPECT_LT((Vector2d(pose_.x_m, pose_.y_m) - Vector2d(2.0, -1.0)).norm(), 0.45);
    EXPECT_EQ(next_state(recovery), RecoveryState::Arrived);
}

TEST_F(Pilots, LeadRoundAWallThatTheMapShows) {
    for (double y = -2.0; y < 1.0; y += 0.05) map_.setPos(1.5F, static_cast<float>(y), 0.1F);
    RecoveryManager recovery = make({}, {{3.0, 0.0}});
    const RecoveryDecision decision = step(recovery);
    EXPECT_GT(decision.waypoint_m.y(), 0.5);
    EXPECT_FALSE(decision.path_m.empty());
    RecoveryParams alone;
    alone.replan = ReplanPolicy::Never;
    RecoveryManager without = make(alone, {{3.0, 0.0}});
    EXPECT_EQ(step(without).waypoint_m, Vector2d(3.0, 0.0));
}

TEST_F(Pilots, StuckTurnToTheWayAndDriveOn) {
    RecoveryManager recovery = make({}, {{-3.0, 0.0}});  // the way leads back
    stuck_ = true;
    EXPECT_EQ(next_state(recovery), RecoveryState::TurningToWay);
    stuck_ = false;
    EXPECT_EQ(next_state(recovery), RecoveryState::Driving);
    EXPECT_NEAR(std::abs(pose_.yaw_rad), M_PI, 0.15);
    EXPECT_NEAR(pose_.x_m, 0.0, 0.01);  // turned on the spot
}

TEST_F(Pilots, ManoeuvresTakeTurnsUntilTheRobotIsBlocked) {
    RecoveryParams params;
    params.recoveries_max = 3;
    RecoveryManager recovery = make(params, {{3.0, 0.0}});
    stuck_ = true;
    using State = RecoveryState;
    const std::vector<State> expected = {
        State::TurningToWay, State::Driving,      State::BackingOff,   State::TurningToWay, State::Driving,
        State::LookingLeft,  State::LookingRight, State::TurningToWay, State::Driving,      State::Blocked};
    for (const State state : expected) EXPECT_EQ(next_state(recovery), state) << to_string(state);
}

TEST_F(Pilots, LookToTheLeftFirstAndThenToTheRight) {
    RecoveryManager recovery = make({}, {{3.0, 0.0}});
    stuck_ = true;
    while (state_ != RecoveryState::LookingLeft) next_state(recovery);
    const double ahead_rad = pose_.yaw_rad;
    EXPECT_EQ(next_state(recovery), RecoveryState::LookingRight);
    EXPECT_NEAR(pose_.yaw_rad - ahead_rad, RecoveryParams().look_rad, 0.15);
    next_state(recovery);
    EXPECT_NEAR(pose_.yaw_rad - ahead_rad, -RecoveryParams().look_rad, 0.15);
}

TEST_F(Pilots, WhatTheGuardHoldsTriesSomethingElse) {
    RecoveryManager recovery = make({}, {{3.0, 0.0}});
    const Pose2 held = pose_;
    std::vector<RecoveryState> states;
    std::vector<double> since_s;
    while (time_s_ < 20.0) {
        const RecoveryState state = step(recovery).state;
        pose_ = held;
        if (!states.empty() && states.back() == state) continue;
        states.push_back(state);
        since_s.push_back(time_s_);
    }
    EXPECT_GT(std::count(states.begin(), states.end(), RecoveryState::BackingOff), 0);
    EXPECT_GT(std::count(states.begin(), states.end(), RecoveryState::LookingLeft), 0);
    for (std::size_t i = 1; i < since_s.size(); ++i)
        EXPECT_LT(since_s[i] - since_s[i - 1], 2.5) << to_string(states[i - 1]);
}

TEST_F(Pilots, GoAnotherWayWhenOneHoldsThemTwice) {
    // A wall at x = 2 with two gaps; the robot cannot pass the nearer one.
    for (float y = -5.0F; y < 5.0F; y += 0.1F)
        if (std::abs(y - 0.5F) > 0.5F && std::abs(y + 3.0F) > 0.5F) map_.setPos(2.0F, y, 0.0F);
    RecoveryManager recovery = make({}, {{4.0, 0.0}});
    while (time_s_ < 90.0 && state_ != RecoveryState::Arrived) {
        const Pose2 before = pose_;
        state_ = step(recovery).state;
        if (pose_.x_m > 1.75 && pose_.x_m < 2.3 && pose_.y_m > -2.0)
            pose_ = {before.x_m, before.y_m, pose_.yaw_rad};
    }
    EXPECT_EQ(state_, RecoveryState::Arrived);
}

TEST_F(Pilots, BackOffNoFartherThanTheGroundIsKnown) {
    for (const double known_m : {0.1, 5.0}) {
        pose_ = {};
        state_ = RecoveryState::Driving;
        local_.fill(0.9F);
        for (float y = -1.0F; y < 1.0F; y += 0.05F)
            for (float x = -5.0F; x < -0.25 - known_m; x += 0.05F) local_.setPos(x, y, 0.5F);
        RecoveryManager recovery = make({}, {{3.0, 0.0}});
        stuck_ = true;
        while (state_ != RecoveryState::BackingOff) next_state(recovery);
        const double before_m = pose_.x_m;
        next_state(recovery);
        const double moved_m = before_m - pose_.x_m;
        EXPECT_NEAR(moved_m, known_m > 1.0 ? RecoveryParams().back_off_m : 0.0, 0.1);
        EXPECT_LE(moved_m, known_m);
    }
}

TEST_F(Pilots, GoWhereSomethingStoodWhenThereIsNoOtherWay) {
    for (float y = -10.0F; y < 10.0F; y += 0.1F) map_.setPos(2.0F, y, 0.0F);
    const auto way = [this] {
        return make({}, {{4.0, 0.0}}).decide({0.0, {}, {}, &local_, true}, map_).path_m.back();
    };
    EXPECT_NEAR(way().x(), 4.0, 0.2);  // the local map no longer shows the wall
    for (float y = -5.0F; y < 5.0F; y += 0.1F) local_.setPos(2.0F, y, 0.0F);
    EXPECT_LT(way().x(), 2.0);
}

TEST_F(Pilots, BackOffOverTheWayTheyCame) {
    RecoveryManager recovery = make({}, {{3.0, 0.0}});
    while (pose_.x_m < 1.5) step(recovery);
    local_.fill(0.5F);  // the map no longer shows the driven ground
    stuck_ = true;
    while (state_ != RecoveryState::BackingOff) next_state(recovery);
    const double before_m = pose_.x_m;
    next_state(recovery);
    EXPECT_NEAR(before_m - pose_.x_m, RecoveryParams().back_off_m, 0.1);
}

TEST_F(Pilots, ABlindSensorIsNoReasonForManoeuvres) {
    RecoveryManager recovery = make({}, {{3.0, 0.0}});
    stuck_ = true;
    for (int i = 0; i < 100; ++i) {
        const Situation situation{0.2 * i, pose_, {}, &local_, false};
        EXPECT_EQ(recovery.decide(situation, map_).state, RecoveryState::Driving);
    }
}

TEST_F(Pilots, AFollowerThatIsHeldBacksOffTurnsAwayAndGoesOn) {
    for (const double y_m : {2.0, -2.0}) {
        const RecoveryState away = y_m > 0.0 ? RecoveryState::LookingRight : RecoveryState::LookingLeft;
        RecoveryManager recovery(RobotModel(), {}, std::make_unique<SimpleNavigator>(stuck_),
                                 Vector2d(5.0, y_m));
        std::vector<RecoveryState> states;
        const double begin_s = time_s_;
        while (time_s_ < begin_s + 12.0 && (states.empty() || states.back() != away)) {
            const Pose2 held = pose_;
            states.push_back(step(recovery).state);
            if (states.back() == RecoveryState::Driving) pose_ = held;
        }
        EXPECT_EQ(states.front(), RecoveryState::Driving);
        EXPECT_GT(std::count(states.begin(), states.end(), RecoveryState::BackingOff), 3);
        EXPECT_EQ(states.back(), away);
        while (time_s_ < begin_s + 30.0) state_ = step(recovery).state;
        EXPECT_EQ(state_, RecoveryState::Driving);
    }
}

TEST_F(Pilots, AFollowerTakesItsRecoveriesFromTheParameters) {
    for (const double held_s : {1.0, 4.0}) {
        RecoveryParams params;
        params.held_s = held_s;
        RecoveryManager recovery(RobotModel(), params, std::make_unique<SimpleNavigator>(stuck_),
                                 Vector2d(5.0, 2.0));
        time_s_ = 0.0;
        do {
            state_ = step(recovery).state;
            pose_ = {};
        } while (state_ == RecoveryState::Driving && time_s_ < 10.0);
        EXPECT_NEAR(time_s_, held_s, 0.5);
    }
}

TEST_F(Pilots, AFollowerThatCanNeitherTurnNorBackOffCreepsOn) {
    RecoveryManager recovery(RobotModel(), {}, std::make_unique<SimpleNavigator>(stuck_), Vector2d(5.0, 2.0));
    while (time_s_ < 20.0 && state_ != RecoveryState::CreepingOn) {
        const Pose2 held = pose_;
        state_ = step(recovery).state;
        if (state_ != RecoveryState::CreepingOn) pose_ = held;
    }
    EXPECT_EQ(step(recovery).state, RecoveryState::CreepingOn);
    EXPECT_GT(motion_.v_mps, 0.0);
    EXPECT_LT(motion_.v_mps, CollisionCheckerParams().crawl_mps);
    EXPECT_EQ(motion_.omega_radps, 0.0);
}

TEST_F(Pilots, AWayPointOfTheRobotsFrameMovesWithIt) {
    RecoveryManager recovery(RobotModel(), {}, std::make_unique<SimpleNavigator>(stuck_), Vector2d(5.0, 2.0));
    pose_ = {1.0, 0.0, M_PI / 2};
    const RecoveryDecision decision = step(recovery);
    EXPECT_NEAR(decision.waypoint_m.x(), -1.0, 1e-9);
    EXPECT_NEAR(decision.waypoint_m.y(), 5.0, 1e-9);
}

TEST(RecoveryManager, WithoutAGoalIsRefused) {
    const bool stuck = false;
    EXPECT_THROW(RecoveryManager(RobotModel(), RecoveryParams(), std::make_unique<SimpleNavigator>(stuck),
                                 std::vector<Vector2d>{}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace flownav::nav
