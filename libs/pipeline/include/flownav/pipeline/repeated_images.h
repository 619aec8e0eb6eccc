#pragma once

#include <array>
#include <cstddef>

#include "flownav/core/image_view.h"

namespace flownav::pipeline {

/// Tells a camera that is stuck: noise lets no two images be alike to the last pixel.
class RepeatedImages {
  public:
    /// Whether `image`, the newest, is one of the two before: those of a frozen frame of two fields take
    /// turns.
    bool is_repeated(const ImageView& image);

  private:
    std::array<std::size_t, 2> before_ = {};  ///< digests, the newer one first
};

}  // namespace flownav::pipeline
