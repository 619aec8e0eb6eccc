#pragma once
#include <cstdint>
#include <filesystem>

#include "flownav/core/field.h"
#include "flownav/io/output_file.h"
#include "flownav/pipeline/step.h"

namespace flownav::io {

/// A gz rawlog of CObservationFlowField, one a field. Apart from result.rawlog, because MRPT's programs stop
/// at a class they do not know. Everything throws OutputError when it cannot be written.
class FlowFieldFile {
  public:
    explicit FlowFieldFile(const std::filesystem::path& path) : file_(path) {}

    void write(const Field& field, const pipeline::Step& step);
    void close() { file_.close(); }

  private:
    GzOutputFile file_;
};

}  // namespace flownav::io
