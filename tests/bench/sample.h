#pragma once
#include <filesystem>
#include <vector>

#include "flownav/core/field.h"

namespace flownav::bench {

/// Returns $FLOWNAV_DATA, or shared/data beside the project; the folder may be missing.
std::filesystem::path data_folder();

/// Returns the rawlog to measure: scenes/field.rawlog of the test data (768x288) if it exists, else the
/// project's own corridor (320x240).
std::filesystem::path sample_rawlog();

/// Reads and decodes all fields.
std::vector<Field> read_fields(const std::filesystem::path& rawlog);

/// The fields of sample_rawlog(), read once.
const std::vector<Field>& sample_fields();

}  // namespace flownav::bench
