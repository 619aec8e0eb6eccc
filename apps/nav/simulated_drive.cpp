#include "simulated_drive.h"

#include <mrpt/core/Clock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

#include "camera_thread.h"
#include "flownav/pipeline/pipeline.h"
#include "flownav/sensor/make_state.h"
#include "flownav/sim/collision.h"
#include "flownav/sim/vehicle.h"
#include "robot_drive.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

constexpr double tick_s = 0.02;  // of wheels, guard and motors
constexpr double epoch_s = sim::sim_start_s;

nav::GuardParams guard_params(const SimulatedDriveOptions& options) {
    nav::GuardParams params = options.guard;
    params.needs_fields = options.sensor == SensorKind::Flow;
    return params;
}

Vector2d position(const Pose2& pose) {
    return {pose.x_m, pose.y_m};
}

/// MRPT's clock shows simulated time as long as this lives.
class SimulatedClock {
  public:
    SimulatedClock() {
        mrpt::Clock::setActiveClock(mrpt::Clock::Simulated);
        set(0.0);
    }
    ~SimulatedClock() { mrpt::Clock::setActiveClock(mrpt::Clock::Realtime); }
    SimulatedClock(const SimulatedClock&) = delete;
    SimulatedClock& operator=(const SimulatedClock&) = delete;

    static void set(double time_s) {
        mrpt::Clock::setSimulatedTime(mrpt::Clock::fromDouble(epoch_s + time_s));
    }
};

/// A scan of the ideal lidar as the maps take it: points, and free ground before them.
nav::Sensed sensed(const VirtualScan& scan, const sim::LidarParams& lidar, double time_s) {
    nav::Sensed sensed;
    sensed.report.timestamp_s = time_s;
    sensed.by_camera = false;
    sensed.report.end_of_cycle = true;
    for (std::size_t i = 0; i < scan.beams.size(); ++i) {
        const Beam& beam = scan.beams[i];
        const double bearing_rad = scan.first_bearing_rad + static_cast<double>(i) * scan.step_rad;
        const Vector2d direction(std::cos(bearing_rad), std::sin(bearing_rad));
        if (beam.kind == BeamKind::Obstacle) {
            ObstaclePoint point;
            point.position_m << beam.range_m * direction, lidar.height_m;
            point.sigma_m = 0.01;
            sensed.points.push_back(point);
        }
        const double far_m = beam.range_m - (beam.kind == BeamKind::Obstacle ? 0.1 : 0.0);
        if (far_m > 0.0) sensed.ground.push_back({Vector2d::Zero(), far_m * direction});
    }
    return sensed;
}

/// The simulated robot, its sensors and its autopilot, event by event.
class Drive {
  public:
    Drive(const SimulatedDriveOptions& options, DriveObserver& observer)
        : options_(options),
          observer_(observer),
          vehicle_(options.config.navigation.robot, options.start),
          wheels_(options.odometry),
          state_(make_state(options.config)),
          autopilot_(
              options.config.navigation, options.config.map, guard_params(options),
              make_pilot(options.config, options.goals_m, options.waypoint_robot_m, options.navlog_directory),
              options.start) {
        if (options.sensor == SensorKind::Flow) camera_.emplace(options.world, options.camera);
        result_.min_clearance_m = std::numeric_limits<double>::infinity();
    }

    DriveResult result() {
        for (int tick = 0; !over_; ++tick) {
            const double time_s = tick * tick_s;
            if (options_.sensor == SensorKind::Flow) {
                take_fields(time_s);
            } else {
                take_scans(time_s);
            }
            control(time_s);
        }
        const auto& events = autopilot_.guard().events();
        result_.stops.assign(events.begin(), events.end());
        return std::move(result_);
    }

  private:
    struct Arriving {
        double time_s;
        nav::Sensed sensed;
    };

    void take_fields(double until_s) {
        for (; field_ / options_.camera.rate_hz <= until_s; ++field_) {
            const double time_s = field_ / options_.camera.rate_hz;
            vehicle_.advance(time_s);
            Field field = camera_->take(field_, vehicle_.pose(), time_s);
            field.timestamp_s = epoch_s + time_s;
            observer_.on_truth(field.timestamp_s, vehicle_.pose());
            if (options_.faults.field) {
                auto altered = options_.faults.field(field);
                if (!altered) continue;
                field = std::move(*altered);
            }
            const pipeline::Step& step = pipeline::step(state_, field);
            observer_.on_field(field, step);
            send(time_s, sensed_of(step, field, images_, epoch_s));
        }
    }

    void take_scans(double until_s) {
        for (; field_ / options_.lidar.rate_hz <= until_s; ++field_) {
            const double time_s = field_ / options_.lidar.rate_hz;
            vehicle_.advance(time_s);
            send(time_s, sensed(sim::scan(options_.world, options_.lidar, vehicle_.pose(), time_s),
                                options_.lidar, time_s));
        }
    }

    void send(double time_s, nav::Sensed sensed) {
        const double more_s = options_.faults.field_delay_s ? options_.faults.field_delay_s(time_s) : 0.0;
        arriving_.push_back({time_s + options_.latency_s + more_s, std::move(sensed)});
    }

    void control(double time_s) {
        SimulatedClock::set(time_s);
        vehicle_.advance(time_s);
        Pose2 odometry = wheels_.update(vehicle_.pose());
        if (options_.faults.odometry) odometry = options_.faults.odometry(time_s, odometry);
        observer_.on_odometry(epoch_s + time_s, odometry);
        autopilot_.odometry(time_s, odometry, vehicle_.motion());
        while (!arriving_.empty() && arriving_.front().time_s <= time_s) {
            autopilot_.sensed(arriving_.front().sensed);
            arriving_.pop_front();
        }
        const MotionCommand command = autopilot_.command(time_s, options_.faults.navigator);
        vehicle_.command(time_s, command);
        note(time_s, odometry, command);
        judge(time_s);
    }

    void note(double time_s, const Pose2& odometry, const MotionCommand& command) {
        const sim::Clearance clear =
            sim::clearance(options_.world, options_.config.navigation.robot, vehicle_.pose(), time_s);
        DriveSample sample;
        sample.time_s = time_s;
        sample.T_world_robot = vehicle_.pose();
        sample.T_map_robot = autopilot_.T_map_robot();
        sample.odometry = odometry;
        sample.motion = vehicle_.motion();
        sample.proposed = autopilot_.decision().command;
        sample.command = command;
        sample.clearance_m = clear.distance_m;
        if (!result_.samples.empty()) {
            result_.path_m +=
                (position(sample.T_world_robot) - position(result_.samples.back().T_world_robot)).norm();
        }
        result_.min_clearance_m = std::min(result_.min_clearance_m, clear.distance_m);
        result_.samples.push_back(sample);
        touched_ = clear.distance_m <= 0.0 ? clear.nearest : "";
        observer_.on_tick(sample);
        if (autopilot_.just_decided()) observer_.on_decision(sample, autopilot_);
    }

    void judge(double time_s) {
        result_.time_s = time_s;
        const nav::PilotDecision& decision = autopilot_.decision();
        if (!touched_.empty()) {
            end(Outcome::Collision, "touched " + touched_);
            result_.contact_speed_mps = std::abs(vehicle_.motion().v_mps);
        } else if (is_at_goal() || result_.path_m >= options_.way_max_m) {
            end(Outcome::Reached, "");
        } else if (decision.state == nav::PilotState::Blocked) {
            end(Outcome::Blocked, decision.why);
        } else if (time_s >= options_.timeout_s - tick_s / 2) {
            end(Outcome::Timeout, decision.why);
        }
    }

    bool is_at_goal() const {
        if (options_.goals_m.empty() || options_.waypoint_robot_m) return false;
        // Way points before the goal are the pilot's business.
        const bool last = options_.goals_m.size() == 1 || autopilot_.decision().last_goal;
        const double distance_m = (options_.goals_m.back() - position(vehicle_.pose())).norm();
        return last && distance_m <= options_.success_radius_m;
    }

    void end(Outcome outcome, std::string why) {
        result_.outcome = outcome;
        result_.why = std::move(why);
        over_ = true;
    }

    const SimulatedDriveOptions& options_;
    DriveObserver& observer_;
    SimulatedClock clock_;
    sim::Vehicle vehicle_;
    sim::WheelOdometry wheels_;
    std::optional<sim::CameraSimulator> camera_;
    pipeline::RepeatedImages images_;
    pipeline::State state_;
    nav::Autopilot autopilot_;
    std::deque<Arriving> arriving_;
    int field_ = 0;  ///< the next one, or the next scan
    std::string touched_;
    bool over_ = false;
    DriveResult result_;
};

}  // namespace

const char* to_string(Outcome outcome) {
    constexpr std::array<const char*, 4> words = {"reached", "blocked", "collision", "timeout"};
    return words[static_cast<std::size_t>(outcome)];
}

DriveResult simulate_drive(const SimulatedDriveOptions& options, DriveObserver& observer) {
    return Drive(options, observer).result();
}

}  // namespace flownav
