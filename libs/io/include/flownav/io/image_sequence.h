#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/core/pose2.h"
#include "flownav/core/readings.h"

namespace flownav::io {

/// Image of a data set, and the robot's pose at its time when the data set has poses.
struct SequenceFrame {
    Field field;
    std::optional<Pose2> T_start_robot;
};

/// Images of a data set in order, with calibration, rising times and optional poses. Constructors throw
/// InputError when the data set is missing or inconsistent.
class ImageSequence {
  public:
    ImageSequence() = default;
    virtual ~ImageSequence() = default;
    ImageSequence(const ImageSequence&) = delete;
    ImageSequence& operator=(const ImageSequence&) = delete;

    /// Next readable image; empty at the end.
    virtual std::optional<SequenceFrame> next() = 0;

    /// Expected number of images; 0: unknown.
    virtual std::size_t size() const = 0;

    /// Readings of a gyro that come with the images, in the order of their times; empty: there are none.
    virtual std::vector<GyroRate> gyro() const { return {}; }

    /// Messages about images that could not be read or are missing, one sentence each.
    const std::vector<std::string>& problems() const { return problems_; }

    /// What was recognised, assumed or mended, one sentence each; nothing was lost by it.
    const std::vector<std::string>& notes() const { return notes_; }

  protected:
    void add_problem(const std::string& problem) { problems_.push_back(problem); }
    void add_note(const std::string& note) { notes_.push_back(note); }

  private:
    std::vector<std::string> notes_;
    std::vector<std::string> problems_;
};

}  // namespace flownav::io
