#pragma once
#include <filesystem>
#include <string>

namespace flownav::io {

/// Reason why a path cannot be read as a rawlog: it does not exist, is not accessible, or is a folder. Empty
/// when it can.
std::string problem_of_input(const std::filesystem::path& input);

}  // namespace flownav::io
