#pragma once
#include <mrpt/math/TPose3D.h>

#include <filesystem>

#include "flownav/core/pose2.h"
#include "flownav/io/output_file.h"

namespace flownav::evaluation {

/// Writes a trajectory in TUM format, one pose per line: timestamp x y z qx qy qz qw (seconds, metres). All
/// functions throw OutputError.
class TrajectoryFile {
  public:
    explicit TrajectoryFile(const std::filesystem::path& path) : file_(path) {}

    void write(double timestamp_s, const mrpt::math::TPose3D& pose);
    void write(double timestamp_s, const Pose2& pose);
    void close() { file_.close(); }

  private:
    io::OutputFile file_;
};

}  // namespace flownav::evaluation
