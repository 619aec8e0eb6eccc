#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "flownav/core/image_view.h"

namespace flownav::bench {

/// A vector of FFmpeg's motion estimation, from the last image but one to the last.
struct MestimateVector {
    Eigen::Vector2d at_px;  ///< centre of the 16x16 block, pixel centres being integers
    Eigen::Vector2d flow_px;
};

/// FFmpeg's filter `mestimate` in this process: 16x16 blocks side by side, offsets up to +-8 px.
class Mestimate {
  public:
    /// method: "esa", "epzs", ... Throws std::runtime_error when FFmpeg refuses.
    Mestimate(int width_px, int height_px, const std::string& method);
    ~Mestimate();
    Mestimate(const Mestimate&) = delete;
    Mestimate& operator=(const Mestimate&) = delete;

    /// Takes the next image in. The filter measures both ways, toward the image before and the image behind.
    /// Returns how many vectors that gave.
    std::size_t push(const ImageView& image);

    /// Of the last push(), those toward the image behind.
    const std::vector<MestimateVector>& vectors() const { return vectors_; }

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
    std::vector<MestimateVector> vectors_;
};

}  // namespace flownav::bench
