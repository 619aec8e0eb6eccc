#pragma once
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/evaluation/pose_fit.h"
#include "flownav/pipeline/step.h"

namespace flownav::evaluation {

/// Whether the camera's pose agrees with what the drive shows.
struct CameraCheck {
    static constexpr double angle_limit_deg = 1.0;  ///< an error beyond this is reported
    static constexpr double ratio_low = 0.8;        ///< odometry over flow odometry
    static constexpr double ratio_high = 1.25;

    int pairs = 0;                  ///< cycles that showed enough floor
    motion::PoseCorrection angles;  ///< what would have to be added to pitch, roll and yaw
    double agreeing = 0.0;          ///< share of the vectors of the near floor that do agree with a plane
    bool angles_known = false;      ///< whether that means anything
    std::optional<ScaleFit> scale;  ///< odometry over flow odometry
    double height_m = 0.0;          ///< as assumed
    std::vector<std::string> warnings;

    /// consistent, not_determined, pose_contradicts_flow, height_contradicts_odometry
    const char* verdict = "not_determined";
};

/// Collects from the steps of a drive what tells the pose of the camera.
class CameraChecker {
  public:
    explicit CameraChecker(Geometry geometry) : geometry_(geometry) {}

    void take(const Field& field, const pipeline::Step& step);
    CameraCheck result(const PoseTrack& odometry) const;

  private:
    Geometry geometry_;
    CameraMount mount_;
    PoseSum sum_{8};
    double pitch_at_rad_ = 0.0;  ///< correction with which the next pair is seen
    double near_vectors_ = 0.0, close_vectors_ = 0.0;
    double reference_s_ = 0.0;
    std::vector<TravelPiece> pieces_;
    std::vector<RayFlow> rays_;
    motion::PoseScratch scratch_;
};

}  // namespace flownav::evaluation
