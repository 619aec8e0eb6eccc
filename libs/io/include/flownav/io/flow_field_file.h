#pragma once
#include <cstdint>
#include <filesystem>

#include "flownav/core/field.h"
#include "flownav/io/output_file.h"
#include "flownav/pipeline/step.h"

namespace flownav::io {

/// Writes a gz rawlog with one CObservationFlowField per field. It is separate from result.rawlog because
/// MRPT's programs stop at unknown classes. All functions throw OutputError.
class FlowFieldFile {
  public:
    explicit FlowFieldFile(const std::filesystem::path& path) : file_(path) {}

    void write(const Field& field, const pipeline::Step& step);
    void close() { file_.close(); }

  private:
    GzOutputFile file_;
};

}  // namespace flownav::io
