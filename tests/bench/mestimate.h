#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "flownav/core/image_view.h"

namespace flownav::bench {

/// A vector of FFmpeg's motion estimation between the last two images.
struct MestimateVector {
    Eigen::Vector2d at_px;  ///< centre of the 16x16 block; pixel centres are integers
    Eigen::Vector2d flow_px;
};

/// FFmpeg's filter `mestimate` in this process: adjacent 16x16 blocks, offsets up to +-8 px.
class Mestimate {
  public:
    /// `method`: "esa", "epzs", ... Throws std::runtime_error when FFmpeg rejects it.
    Mestimate(int width_px, int height_px, const std::string& method);
    ~Mestimate();
    Mestimate(const Mestimate&) = delete;
    Mestimate& operator=(const Mestimate&) = delete;

    /// Adds the next image. The filter measures in both directions, to the previous and to the next image.
    /// Returns the number of vectors.
    std::size_t push(const ImageView& image);

    /// Vectors of the last push() toward the previous image.
    const std::vector<MestimateVector>& vectors() const { return vectors_; }

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
    std::vector<MestimateVector> vectors_;
};

}  // namespace flownav::bench
