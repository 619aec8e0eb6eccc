#pragma once
#include <optional>

#include "flownav/core/ego_motion.h"
#include "flownav/core/sensor_agreement.h"
#include "flownav/motion/agreement.h"
#include "flownav/motion/gyro_track.h"
#include "flownav/motion/wheel_track.h"
#include "flownav/pipeline/params.h"

namespace flownav::pipeline {

/// A quantity of the motion between two times as another sensor tells it.
struct ToldValue {
    double value = 0.0;  ///< m or rad
    double sigma = 0.0;  ///< standard error
    MotionSource source = MotionSource::Prediction;
    SensorUse use = SensorUse::Fallback;
    /// Where it differs much from the flow in one field, the flow is wrong. True for a gyro that agreed with
    /// the flow over the last seconds: it neither slips nor follows a moving object.
    bool outdoes_flow = false;

    bool is_prior() const { return use == SensorUse::Prior; }
};

/// The motion between two times as wheels and gyro tell it. A part is empty when no sensor tells it, or none
/// that agrees with the flow.
struct ToldMotion {
    std::optional<ToldValue> turn;  ///< of the gyro, else of the wheels
    std::optional<ToldValue> way;   ///< of the wheels: chord, > 0 forward
    double chord_rad = 0.0;         ///< see EgoMotion; of the wheels
};

/// Adds the told parts to those that the flow did not measure.
EgoMotion completed(EgoMotion motion, const ToldMotion& told);

/// Averages measured parts with those that are told as a prior, by their standard errors. Where they differ
/// by more than 3 standard deviations, the measured part stays, or the told one replaces it if that outdoes
/// the flow.
EgoMotion averaged(EgoMotion motion, const ToldMotion& told);

/// The pose after a told motion in the frame before it; empty unless turn and way are told.
std::optional<Pose2> told_pose(const ToldMotion& told);

/// The readings of wheels and gyro, and how they agree with the flow. Allocates no memory.
class OtherSensors {
  public:
    explicit OtherSensors(const OtherSensorParams& params) : params_(params) {}

    void note(const WheelPose& reading);
    void note(const GyroRate& reading);

    /// The motion between the times of two fields.
    ToldMotion between(double from_s, double to_s) const;

    /// Compares with the motion that the flow measured between two fields, and learns the bias of the gyro.
    void compare(double from_s, double to_s, const EgoMotion& flow);

    /// Compares the times of the readings with that of the newest field, and learns the bias of the gyro
    /// while the wheels stand.
    void note_field(double timestamp_s);

    SensorChecks checks() const;

  private:
    void compare_wheels(double from_s, double to_s, const EgoMotion& flow);
    void compare_gyro(double from_s, double to_s, const EgoMotion& flow);

    OtherSensorParams params_;
    motion::WheelTrack wheels_;
    motion::GyroTrack gyro_;
    motion::Agreement way_{{0.15, 0.05, 0.25}};
    motion::Agreement turn_{{0.15, 0.05, 0.25}};
    motion::Agreement gyro_turn_{{0.15, 0.05, 0.25}};
    int wheels_late_ = 0;  ///< fields in a row that are far from the newest reading
    int gyro_late_ = 0;
    double stood_s_ = 0.0;  ///< time of the last lesson of standing wheels
};

}  // namespace flownav::pipeline
