#pragma once
#include <optional>
#include <vector>

#include "flownav/evaluation/calibration_drive.h"
#include "flownav/motion/pose_error.h"

namespace flownav::evaluation {

/// Adds up the equations of pairs in the order of the drive. Neighbouring pairs see the same floor, so their
/// errors are alike: the scatter that tells the uncertainty is that between groups of them.
class PoseSum {
  public:
    explicit PoseSum(int pairs_per_group) : pairs_per_group_(pairs_per_group) {}

    /// `at_rad`: the correction with which the pair was seen.
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

/// Angles of the camera that explain a drive.
struct AnglesFit {
    motion::MountAngles correction_rad =
        motion::MountAngles::Zero();  ///< of the mounts that the pairs come with
    motion::MountAngles sigma_rad = motion::MountAngles::Constant(motion::unknown_angle_rad);
    motion::PitchPrior pitch_prior;  ///< as the drive showed it
    bool settled = false;
    int pairs = 0;
    double agreeing_vectors = 0.0;  ///< that move like the floor, within a pixel or so
    double agreeing = 0.0;          ///< their share of those where the near floor is expected
};

/// Gauss-Newton over all pairs, from a correction to start with.
AnglesFit fit_angles(const std::vector<CalibrationPair>& pairs, const motion::MountAngles& start_rad,
                     const motion::AngleMask& unknown);

/// A pair as a camera of corrected mount sees it.
struct SeenPair {
    CameraModel camera;  ///< of the reference
    RayMapper reference;
    RayMapper newer;
    std::vector<RayFlow> rays;
};

SeenPair seen(const CalibrationPair& pair, const motion::MountAngles& correction_rad);

/// Odometry over flow odometry, which is the true over the assumed height.
struct ScaleFit {
    double ratio = 1.0;
    double sigma = 0.0;
    int pairs = 0;
};

/// A cycle's travel by flow.
struct TravelPiece {
    double begin_s, end_s;
    double forward_m;
};

/// Nothing when odometry and flow share too few pieces of forward driving.
std::optional<ScaleFit> fit_scale(const std::vector<TravelPiece>& flow, const PoseTrack& odometry);

}  // namespace flownav::evaluation
