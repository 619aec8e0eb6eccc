#pragma once
#include <opencv2/core/mat.hpp>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/pipeline/step.h"

namespace flownav {

/// A picture for people (8-bit BGR): the field, stretched so that shapes look right although a PAL field has
/// half the lines; every measured block coloured by its fate with its vector as an arrow that ends where the
/// block is now; below it a legend with counts and the state of the step. Colours stay apart for colour-blind
/// eyes.
cv::Mat annotated_field(const Field& field, const pipeline::Step& step);

/// Keeps a few steps, spread evenly over a drive of unknown length, with the fields they were made from.
class Gallery {
  public:
    /// Considers one more step for keeping. Copies no pixel.
    void offer(const Field& field, const pipeline::Step& step);

    struct Picture {
        Field field;
        pipeline::Step step;
    };

    /// Up to `count` of the kept ones, in order of time, the first and the last among them.
    std::vector<const Picture*> spread(std::size_t count) const;

  private:
    static constexpr std::size_t most_kept = 24;

    std::vector<Picture> kept_;
    std::size_t stride_ = 1;
    std::size_t offered_ = 0;
};

}  // namespace flownav
