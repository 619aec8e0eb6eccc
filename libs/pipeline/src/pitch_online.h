#pragma once
#include <vector>

#include "flownav/motion/estimate_motion.h"
#include "flownav/motion/pose_error.h"

namespace flownav::pipeline {

/// Learns from cycle to cycle how far the camera's true pitch is from the assumed one. A tenth of what a
/// cycle says is believed, of the first few cycles more, and only of images whose near floor is plain to see.
/// Allocates only when more samples come than ever before.
class PitchOnline {
  public:
    double correction_rad() const { return correction_rad_; }

    void restart() { *this = PitchOnline(); }

    /// Takes in an image of the running cycle. `camera`: with the correction so far.
    void observe(const std::vector<motion::MotionSample>& samples, const CameraModel& camera,
                 const EgoMotion& motion, Geometry geometry);

    /// Corrects, at the end of a cycle with this motion.
    void learn(const EgoMotion& motion);

  private:
    double correction_rad_ = 0.0;
    int cycles_ = 2;  ///< believed; begins as if there had been two: no jump after a single one
    double pitch_variance_rad2_ = 3e-8;  ///< of the camera's pitch over a cycle: 0.01 deg to begin with
    motion::PoseEquations cycle_;
    std::vector<RayFlow> rays_;
    motion::PoseScratch scratch_;
};

}  // namespace flownav::pipeline
