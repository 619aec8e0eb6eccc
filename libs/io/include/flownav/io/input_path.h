#pragma once
#include <filesystem>
#include <string>

namespace flownav::io {

/// Why a path cannot be a rawlog to read: it does not exist, cannot be looked at, or is a folder. Empty: it
/// can.
std::string problem_of_input(const std::filesystem::path& input);

}  // namespace flownav::io
