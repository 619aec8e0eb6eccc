#pragma once
#include <filesystem>
#include <vector>

#include "flownav/core/field.h"

namespace flownav::bench {

/// $FLOWNAV_DATA, or shared/data beside the project; need not exist.
std::filesystem::path data_folder();

/// The rawlog that is measured: scenes/field.rawlog of the test data (768x288) when it is there, else the
/// project's own corridor (320x240).
std::filesystem::path sample_rawlog();

/// All of its fields, decoded.
std::vector<Field> read_fields(const std::filesystem::path& rawlog);

/// The fields of sample_rawlog(), read once.
const std::vector<Field>& sample_fields();

}  // namespace flownav::bench
