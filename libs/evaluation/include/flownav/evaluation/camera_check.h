#pragma once
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/evaluation/pose_fit.h"
#include "flownav/pipeline/step.h"

namespace flownav::evaluation {

/// Result of comparing the configured camera pose with the flow of a drive.
struct CameraCheck {
    static constexpr double angle_limit_deg = 1.0;  ///< larger errors are reported
    static constexpr double ratio_low = 0.8;        ///< smallest plausible ratio of odometry to flow odometry
    static constexpr double ratio_high = 1.25;

    int pairs = 0;                  ///< number of cycles with enough floor
    motion::PoseCorrection angles;  ///< corrections of pitch, roll and yaw
    double agreeing = 0.0;          ///< share of the near floor's vectors that agree with a plane
    bool angles_known = false;      ///< true when the drive determines the angles
    std::optional<ScaleFit> scale;  ///< ratio of odometry to flow odometry; empty without odometry
    double height_m = 0.0;          ///< as configured
    std::vector<std::string> warnings;

    /// One of consistent, not_determined, pose_contradicts_flow, height_contradicts_odometry.
    const char* verdict = "not_determined";
};

/// Estimates the pose of the camera from the steps of a drive.
class CameraChecker {
  public:
    explicit CameraChecker(Geometry geometry) : geometry_(geometry) {}

    void take(const Field& field, const pipeline::Step& step);
    CameraCheck result(const PoseTrack& odometry) const;

  private:
    void compare(const Field& field, const pipeline::Step& step);

    Geometry geometry_;
    CameraMount mount_;
    PoseSum sum_{8};
    double pitch_at_rad_ = 0.0;  ///< pitch correction at which the next pair is evaluated
    double near_vectors_ = 0.0, close_vectors_ = 0.0;
    double reference_s_ = 0.0;
    std::vector<TravelPiece> pieces_;
    std::vector<RayFlow> rays_;
    motion::PoseScratch scratch_;
};

}  // namespace flownav::evaluation
