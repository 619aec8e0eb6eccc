#include "flownav/drive/simulated_drive.h"

#include <cmath>
#include <deque>
#include <utility>

#include "flownav/cli/number_text.h"
#include "flownav/config/make_state.h"
#include "flownav/pipeline/pipeline.h"
#include "flownav/sim/collision.h"
#include "flownav/sim/ground.h"
#include "flownav/sim/vehicle.h"
#include "simulated_clock.h"

namespace flownav::drive {
namespace {

using Eigen::Vector2d;

constexpr double epoch_s = sim::sim_start_s;

/// Converts a scan of the ideal lidar to map input: points, and the free ground in front of them.
nav::SensorUpdate update(const VirtualScan& scan, const sim::LidarParams& lidar, double time_s) {
    nav::SensorUpdate update;
    update.report.timestamp_s = time_s;
    update.by_camera = false;
    update.report.end_of_cycle = true;
    for (std::size_t i = 0; i < scan.beams.size(); ++i) {
        const Beam& beam = scan.beams[i];
        const double bearing_rad = scan.first_bearing_rad + static_cast<double>(i) * scan.step_rad;
        const Vector2d direction(std::cos(bearing_rad), std::sin(bearing_rad));
        if (beam.kind == BeamKind::Obstacle) {
            ObstaclePoint point;
            point.position_m << beam.range_m * direction, lidar.height_m;
            point.sigma_m = 0.01;
            update.points.push_back(point);
        }
        const double far_m = beam.range_m - (beam.kind == BeamKind::Obstacle ? 0.1 : 0.0);
        if (far_m > 0.0) update.ground.push_back({Vector2d::Zero(), far_m * direction});
    }
    return update;
}

/// The simulated robot: wheels, sensor and ground truth. Times are seconds since the start.
class SimulatedRobot : public nav::RobotBase, public SensorFeed, public Witness {
  public:
    SimulatedRobot(const SimulatedDriveOptions& options, const Clock& clock, DriveObserver& observer)
        : options_(options),
          clock_(clock),
          observer_(observer),
          vehicle_(options.config.navigation.robot, options.start),
          wheels_(options.odometry),
          state_(config::make_state(options.config)) {
        if (options.sensor == SensorKind::Flow) camera_.emplace(options.world, options.camera);
    }

    /// Reads the sensor before it advances the vehicle, because fields are older than the current time. The
    /// fields are evaluated in arrived(), when the wheels have told the motion up to them.
    std::optional<nav::WheelReading> odometry() override {
        const double now_s = clock_.now_s();
        if (options_.sensor == SensorKind::Flow) {
            capture_fields(now_s);
        } else {
            take_scans(now_s);
        }
        vehicle_.advance(now_s);
        Pose2 T_odom_robot = wheels_.update(vehicle_.pose());
        if (options_.faults.odometry) T_odom_robot = options_.faults.odometry(now_s, T_odom_robot);
        return nav::WheelReading{now_s, T_odom_robot, vehicle_.motion()};
    }

    void drive(const MotionCommand& command) override { vehicle_.command(clock_.now_s(), command); }

    void odometry(const nav::WheelReading& reading) override {
        pipeline::note_wheels(state_, {epoch_s + reading.time_s, reading.T_odom_robot});
    }

    std::vector<nav::SensorUpdate> arrived() override {
        evaluate_fields();
        std::vector<nav::SensorUpdate> due;
        while (!arriving_.empty() && arriving_.front().time_s <= clock_.now_s()) {
            due.push_back(std::move(arriving_.front().update));
            arriving_.pop_front();
        }
        return due;
    }
    std::string end() override { return ""; }

    Truth truth(double time_s, bool last_goal) override {
        const sim::Clearance clear =
            sim::clearance(options_.world, options_.config.navigation.robot, vehicle_.pose(), time_s);
        Truth truth;
        truth.T_world_robot = vehicle_.pose();
        truth.motion = vehicle_.motion();
        truth.clearance_m = clear.distance_m;
        if (clear.distance_m <= 0.0) truth.touched = clear.nearest;
        truth.fell = edge_below();
        truth.T_flat_robot = sim::ride_on_ground(options_.world, vehicle_.pose());
        truth.at_goal = is_at_goal(last_goal);
        return truth;
    }

  private:
    struct Captured {
        double time_s;
        Field field;
    };

    struct Arriving {
        double time_s;
        nav::SensorUpdate update;
    };

    void capture_fields(double until_s) {
        for (; field_ / options_.camera.rate_hz <= until_s; ++field_) {
            const double time_s = field_ / options_.camera.rate_hz;
            vehicle_.advance(time_s);
            Field field = camera_->take(field_, vehicle_.pose(), time_s);
            field.timestamp_s = epoch_s + time_s;
            observer_.on_truth(field.timestamp_s, vehicle_.pose(),
                               sim::ride_on_ground(options_.world, vehicle_.pose()));
            if (options_.faults.field) {
                auto altered = options_.faults.field(field);
                if (!altered) continue;
                field = std::move(*altered);
            }
            captured_.push_back({time_s, std::move(field)});
        }
    }

    void evaluate_fields() {
        for (const Captured& captured : captured_) {
            const pipeline::Step& step = pipeline::step(state_, captured.field);
            observer_.on_field(captured.field, step);
            send(captured.time_s, sensor_update_of(step, captured.field, images_, epoch_s));
        }
        captured_.clear();
    }

    void take_scans(double until_s) {
        for (; field_ / options_.lidar.rate_hz <= until_s; ++field_) {
            const double time_s = field_ / options_.lidar.rate_hz;
            vehicle_.advance(time_s);
            send(time_s, update(sim::scan(options_.world, options_.lidar, vehicle_.pose(), time_s),
                                options_.lidar, time_s));
        }
    }

    void send(double time_s, nav::SensorUpdate update) {
        const double more_s = options_.faults.field_delay_s ? options_.faults.field_delay_s(time_s) : 0.0;
        arriving_.push_back({time_s + options_.latency_s + more_s, std::move(update)});
    }

    /// Place and depth of an edge that the robot is over; empty when it stands on its ground.
    std::string edge_below() const {
        const auto edge =
            sim::overhang(options_.world, options_.config.navigation.robot.footprint_m, vehicle_.pose());
        if (!edge) return "";
        return cli::fixed_text(edge->at_m.x(), 2) + ", " + cli::fixed_text(edge->at_m.y(), 2) + " m, " +
               cli::fixed_text(edge->depth_m, 2) + " m deep";
    }

    /// True only at the final goal; the recovery manager handles way points before it.
    bool is_at_goal(bool last_goal) const {
        if (options_.goals_m.empty() || options_.waypoint_robot_m) return false;
        const Vector2d at(vehicle_.pose().x_m, vehicle_.pose().y_m);
        return (options_.goals_m.size() == 1 || last_goal) &&
               (options_.goals_m.back() - at).norm() <= options_.success_radius_m;
    }

    const SimulatedDriveOptions& options_;
    const Clock& clock_;
    DriveObserver& observer_;
    sim::Vehicle vehicle_;
    sim::WheelOdometry wheels_;
    std::optional<sim::CameraSimulator> camera_;
    pipeline::RepeatedImages images_;
    pipeline::State state_;
    std::vector<Captured> captured_;  ///< fields that have not been evaluated yet
    std::deque<Arriving> arriving_;
    int field_ = 0;  ///< index of the next field or scan
};

/// Adds the epoch of the fields to the times of recorded odometry.
class WithEpoch : public DriveObserver {
  public:
    explicit WithEpoch(DriveObserver& observer) : observer_(observer) {}

    void on_odometry(double timestamp_s, const Pose2& T_odom_robot) override {
        observer_.on_odometry(epoch_s + timestamp_s, T_odom_robot);
    }
    void on_decision(const DriveSample& sample, const nav::NavigationStack& stack) override {
        observer_.on_decision(sample, stack);
    }
    void on_tick(const DriveSample& sample) override { observer_.on_tick(sample); }
    void on_end(const nav::NavigationStack& stack) override { observer_.on_end(stack); }

  private:
    DriveObserver& observer_;
};

}  // namespace

DriveResult simulate_drive(const SimulatedDriveOptions& options, DriveObserver& observer) {
    SimulatedDriveOptions driving = options;
    driving.config.guard.needs_fields = options.sensor == SensorKind::Flow;
    driving.hung_s = 0.0;
    const RobotModel& body = driving.config.navigation.robot;
    if (driving.world.shadow_light)
        driving.world.shadow_light->robot = sim::ShadowBody{body.footprint_m, body.height_m};
    SimulatedClock clock(epoch_s, options.realtime);
    SimulatedRobot robot(driving, clock, observer);
    WithEpoch recorder(observer);
    return drive(driving, {clock, robot, robot, &robot}, recorder);
}

}  // namespace flownav::drive
