#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/core/pose2.h"

namespace flownav::io {

/// An image of a data set, and where the robot was when it was taken, if the data set knows.
struct SequenceFrame {
    Field field;
    std::optional<Pose2> T_start_robot;
};

/// The images of a data set, one after the other, with calibration, times that rise, and perhaps poses.
/// Constructors throw InputError when the data set is not there or does not fit together.
class ImageSequence {
  public:
    ImageSequence() = default;
    virtual ~ImageSequence() = default;
    ImageSequence(const ImageSequence&) = delete;
    ImageSequence& operator=(const ImageSequence&) = delete;

    /// The next image that can be read, or nothing at the end.
    virtual std::optional<SequenceFrame> next() = 0;

    /// Number of images, as far as it is known beforehand; 0: unknown.
    virtual std::size_t size() const = 0;

    /// What could not be read, one sentence each.
    const std::vector<std::string>& problems() const { return problems_; }

  protected:
    void add_problem(const std::string& problem) { problems_.push_back(problem); }

  private:
    std::vector<std::string> problems_;
};

}  // namespace flownav::io
