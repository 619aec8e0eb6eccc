#pragma once
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

namespace flownav::io {

/// Integrates the movement actions of a sensory-frame rawlog to odometry readings. The time stamp is the
/// action's, or that of the following frame when it is missing.
class ActionOdometry {
  public:
    void add(const mrpt::obs::CActionCollection& actions);

    /// Returns the reading of the actions since the last frame; null when there were none.
    mrpt::obs::CObservationOdometry::Ptr take(const mrpt::obs::CSensoryFrame& frame);

  private:
    mrpt::poses::CPose2D pose_;
    mrpt::Clock::time_point timestamp_ = INVALID_TIMESTAMP;
    bool due_ = false;
};

}  // namespace flownav::io
