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

/// Poses over time in the frame of their recording. Samples may be added in any order; of several with the
/// same time the first counts.
class PoseTrack {
  public:
    void add(double timestamp_s, const mrpt::math::TPose3D& pose);
    bool empty() const { return samples_.empty(); }
    std::size_t size() const { return samples_.size(); }
    const std::vector<TimedPose>& samples() const { return samples_; }

    /// Sorts the samples; at() and aligned() need it after the last add().
    void finish();

    /// Interpolated pose at a time: position linear, rotation along the shortest arc. Empty outside the
    /// recorded span.
    std::optional<mrpt::math::TPose3D> at(double timestamp_s) const;

    /// Pose at a time, projected on the ground. Empty outside the recorded span.
    std::optional<Pose2> ground_at(double timestamp_s) const;

    /// Samples from `start_s` on, in the frame of the pose at `start_s`, which is the first element (the
    /// identity). A track that begins later starts with its first sample; one that ends earlier gives an
    /// empty result.
    std::vector<TimedPose> aligned(double start_s) const;

  private:
    std::vector<TimedPose> samples_;
};

}  // namespace flownav::evaluation
