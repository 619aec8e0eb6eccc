#pragma once
#include <filesystem>

#include "flownav/io/output_file.h"
#include "flownav/pipeline/step.h"

namespace flownav::evaluation {

/// Writes egomotion.csv, one row per field. Values without measurement and estimate are empty cells. All
/// functions throw OutputError.
class EgomotionCsv {
  public:
    explicit EgomotionCsv(const std::filesystem::path& path);
    void write(const pipeline::Step& step);
    void close() { file_.close(); }

  private:
    io::OutputFile file_;
};

/// Writes obstacles.csv, one row per obstacle point, in the robot frame at the row's time. All functions
/// throw OutputError.
class ObstaclesCsv {
  public:
    explicit ObstaclesCsv(const std::filesystem::path& path);
    void write(const pipeline::Step& step);
    void close() { file_.close(); }

  private:
    io::OutputFile file_;
};

/// Writes contacts.csv, one row per strip of every scanned cycle, in the robot frame at the row's time.
/// Cells of a contact are empty in a strip without obstacle. All functions throw OutputError.
class ContactsCsv {
  public:
    explicit ContactsCsv(const std::filesystem::path& path);
    void write(const pipeline::Step& step);
    void close() { file_.close(); }

  private:
    io::OutputFile file_;
};

}  // namespace flownav::evaluation
