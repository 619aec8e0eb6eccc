#pragma once
#include <optional>
#include <vector>

#include "flownav/evaluation/calibration_drive.h"
#include "flownav/motion/pose_error.h"

namespace flownav::evaluation {

/// Adds the equations of pairs in the order of the drive. Consecutive pairs see the same floor and have
/// correlated errors, so the uncertainty is computed from the scatter between groups of pairs.
class PoseSum {
  public:
    explicit PoseSum(int pairs_per_group) : pairs_per_group_(pairs_per_group) {}

    /// Adds the equations of a pair. `at_rad`: correction at which the pair was evaluated.
    void add(motion::PoseEquations pair, const motion::MountAngles& at_rad = motion::MountAngles::Zero());

    int pairs() const { return pairs_; }
    const motion::PoseEquations& total() const { return total_; }
    motion::PoseCorrection solution(const motion::AngleMask& unknown = {true, true, true}) const;

  private:
    int pairs_per_group_;
    int pairs_ = 0;
    motion::PoseEquations total_;
    std::vector<motion::PoseEquations> groups_;
};

/// Angles of the camera estimated from a drive.
struct AnglesFit {
    motion::MountAngles correction_rad = motion::MountAngles::Zero();  ///< added to the mounts of the pairs
    motion::MountAngles sigma_rad = motion::MountAngles::Constant(motion::unknown_angle_rad);
    motion::PitchPrior pitch_prior;  ///< estimated from the drive
    bool settled = false;
    int pairs = 0;
    double agreeing_vectors = 0.0;  ///< near vectors within 3.5 standard deviations of the floor's motion
    double agreeing = 0.0;          ///< share of agreeing vectors among the near vectors
};

/// Estimates the unknown angles by Gauss-Newton steps over all pairs, from `start_rad`.
AnglesFit fit_angles(const std::vector<CalibrationPair>& pairs, const motion::MountAngles& start_rad,
                     const motion::AngleMask& unknown);

/// A pair evaluated with a camera of corrected mount.
struct SeenPair {
    CameraModel camera;  ///< corrected camera of the reference
    RayMapper reference;
    RayMapper newer;
    std::vector<RayFlow> rays;
};

SeenPair seen(const CalibrationPair& pair, const motion::MountAngles& correction_rad);

/// Ratio of odometry to flow odometry, which equals the ratio of true to assumed height.
struct ScaleFit {
    double ratio = 1.0;
    double sigma = 0.0;
    int pairs = 0;
};

/// Travel between two times, measured by flow.
struct TravelPiece {
    double begin_s, end_s;
    double forward_m;
};

/// Estimates the ratio; empty when fewer than 8 pieces have travel in both.
std::optional<ScaleFit> fit_scale(const std::vector<TravelPiece>& flow, const PoseTrack& odometry);

}  // namespace flownav::evaluation
