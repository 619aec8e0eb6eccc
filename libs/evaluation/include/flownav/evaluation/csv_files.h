#pragma once
#include <filesystem>

#include "flownav/io/output_file.h"
#include "flownav/pipeline/step.h"

namespace flownav::evaluation {

/// egomotion.csv: one row a field. A number that was not measured, and has no estimate, is an empty cell.
class EgomotionCsv {
  public:
    explicit EgomotionCsv(const std::filesystem::path& path);
    void write(const pipeline::Step& step);
    void close() { file_.close(); }

  private:
    io::OutputFile file_;
};

/// obstacles.csv: one row an obstacle point, in the robot frame at the row's time.
class ObstaclesCsv {
  public:
    explicit ObstaclesCsv(const std::filesystem::path& path);
    void write(const pipeline::Step& step);
    void close() { file_.close(); }

  private:
    io::OutputFile file_;
};

}  // namespace flownav::evaluation
