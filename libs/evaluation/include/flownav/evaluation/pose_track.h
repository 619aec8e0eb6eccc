#pragma once
#include <mrpt/math/TPose3D.h>

#include <optional>
#include <vector>

#include "flownav/core/pose2.h"

namespace flownav::evaluation {

struct TimedPose {
    double timestamp_s = 0.0;
    mrpt::math::TPose3D pose;
};

/// Poses over time, in the frame of whoever recorded them. Samples may come in any order; of several with the
/// same time the first counts.
class PoseTrack {
  public:
    void add(double timestamp_s, const mrpt::math::TPose3D& pose);
    bool empty() const { return samples_.empty(); }
    std::size_t size() const { return samples_.size(); }

    /// Sorts the samples; at() and aligned() need it after the last add().
    void finish();

    /// Pose at a time: positions linear, rotation along the shortest arc. Nothing outside the recorded span.
    std::optional<mrpt::math::TPose3D> at(double timestamp_s) const;

    /// The same on the ground.
    std::optional<Pose2> ground_at(double timestamp_s) const;

    /// The samples from `start_s` on, in the frame of the pose at `start_s`, which comes first as the
    /// identity. A track that begins later starts with its own first sample; one that ends earlier is empty.
    std::vector<TimedPose> aligned(double start_s) const;

  private:
    std::vector<TimedPose> samples_;
};

}  // namespace flownav::evaluation
