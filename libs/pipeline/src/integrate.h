#pragma once
#include "cycle.h"
#include "flownav/core/field_status.h"
#include "measure.h"
#include "other_sensors.h"

namespace flownav::pipeline {

/// The motion of one field since the reference.
struct AcceptedMotion {
    FieldStatus status = FieldStatus::Lost;
    EgoMotion motion;               ///< measured or told, else predicted
    double sigma_v_relative = 1.0;  ///< of the speed; 1: unknown

    /// True when vectors can be evaluated in this motion: the flow measured it, or other sensors told it.
    bool is_usable() const { return motion.omega_measured; }
    /// True when the whole motion was told by other sensors, as if the flow had measured it.
    bool is_told() const {
        return status != FieldStatus::Ok && motion.omega_measured && motion.forward_measured;
    }
};

/// Accepts the measured motion when it is credible, else the prediction; parts that are not measured then are
/// taken from other sensors. The status tells what the camera saw, whatever others tell. `sigma_v_relative`:
/// of the speed before this field.
AcceptedMotion estimate(const Measurement& measured, bool is_credible,
                        const motion::MotionPrediction& prediction, const ToldMotion& told,
                        double sigma_v_relative, double since_last_s);

/// The geometry in which the vectors of an image with this motion are evaluated.
ImageOfCycle image_of_cycle(const CameraModel& reference, const EgoMotion& motion, double noise_factor,
                            Geometry geometry);

/// Odometry of the running cycle.
struct Odometry {
    Pose2 T_start_reference;
    EgoMotion counted;        ///< since the reference, as T_start_robot has it
    EgoMotion measured;       ///< since the reference, measured last in this cycle; zero at the reference
    double measured_s = 0.0;  ///< time stamp of `measured`
};

/// Pose and rates after one field.
struct IntegratedMotion {
    EgoMotion counted;  ///< since the reference
    Pose2 T_start_robot;
    Rates rates;               ///< for the next prediction
    double omega_radps = 0.0;  ///< 0 once a turn is no longer carried over
    double v_mps = 0.0;        ///< 0 once a speed is no longer carried over
    double pitch_rate_radps = 0.0;
};

/// Adds a motion to the odometry. A part that is not measured is carried over for `carry_max_s` at the most.
IntegratedMotion integrate(const AcceptedMotion& accepted, const Odometry& odometry, const Rates& before,
                           double timestamp_s, const Elapsed& elapsed, double carry_max_s);

/// Motion over a field that cannot be compared.
struct CarriedMotion {
    double omega_radps = 0.0;
    double v_mps = 0.0;
    Pose2 T_before_now;
    EgoMotion told;  ///< since the reference, as other sensors tell it; no part measured: by none
};

/// The same motion as other sensors tell it: `step` from the field before, `since_reference` from the
/// reference. A part that is not told stays as it was carried over.
CarriedMotion told_instead(const CarriedMotion& carried, const ToldMotion& step,
                           const ToldMotion& since_reference, double since_field_s);

/// Carries the rates on for `carry_max_s` at the most. `since_picture_s`: since the last field that was
/// compared; `since_field_s`: since the field before.
CarriedMotion carry_over(const Rates& rates, double since_picture_s, double since_field_s,
                         double carry_max_s);

}  // namespace flownav::pipeline
