#pragma once
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

namespace flownav::io {

/// Turns the movement actions of a sensory-frame rawlog into odometry readings: the integral of their
/// increments, stamped with the action's time or, where that is missing, with that of the frame after it.
class ActionOdometry {
  public:
    void add(const mrpt::obs::CActionCollection& actions);

    /// A reading that became due with this frame, or null.
    mrpt::obs::CObservationOdometry::Ptr take(const mrpt::obs::CSensoryFrame& frame);

  private:
    mrpt::poses::CPose2D pose_;
    mrpt::Clock::time_point timestamp_ = INVALID_TIMESTAMP;
    bool due_ = false;
};

}  // namespace flownav::io
